// Where the fonts lie that the program brings with it. Any thread.
#pragma once

#include <string>
#include <string_view>

namespace ghostforce {

// For labels in the scene, on the screen and in vector pictures.
inline constexpr std::string_view label_font_file = "DejaVuSans.ttf";
inline constexpr std::string_view bold_label_font_file = "DejaVuSans-Bold.ttf";

// The path of a font by its file's name. Throws Failure(file_trouble) where it is not beside the program.
std::string font_file(std::string_view name);

}  // namespace ghostforce
