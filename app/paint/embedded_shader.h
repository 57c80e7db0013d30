// The shaders that the program brings with it. Any thread.
#pragma once

#include <string_view>

namespace ghostforce {

// The source of a shader by its file's name.
std::string_view embedded_shader(std::string_view name);

}  // namespace ghostforce
