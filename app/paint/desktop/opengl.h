// OpenGL on the desktop: 3.3 core.
#pragma once

#include <glad/gl.h>

namespace ghostforce::gl {

// The first line of a shader, and everything that stands before what a file of shaders/ holds.
inline constexpr const char* shader_version = "#version 330 core";
inline constexpr const char* shader_prologue = "#version 330 core\n";

}  // namespace ghostforce::gl
