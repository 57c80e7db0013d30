// The shaders that the program brings with it, and a pair of shaders made into a program. To make one needs the thread
// that holds the context.
#pragma once

#include <stdexcept>
#include <string_view>

#include "app/paint/handle.h"

namespace ghostforce {

// The source of a shader by its file's name.
std::string_view embedded_shader(std::string_view name);

namespace gl {

// Carries the driver's log and the numbered source, because "0:17: syntax error" alone sends nobody to the right line.
class ShaderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Compiles and links a pair of shaders. The sources are GLSL without "#version": each platform has its own, which
// replaces such a line. Throws ShaderError.
Program link_program(std::string_view vertex_source, std::string_view fragment_source);

}  // namespace gl

}  // namespace ghostforce
