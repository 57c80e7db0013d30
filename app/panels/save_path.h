// The path of a file to be saved: what is proposed, and what would happen to the one typed.
#pragma once

#include <string>
#include <string_view>

#include "app/panels/panel.h"

namespace ghostforce {

// The first that is free of STEM.EXTENSION, STEM-2.EXTENSION … in the folder that the program was started in, absolute.
std::string proposed_path(std::string_view stem, std::string_view extension);

// A name for a file from a scene's title: letters, digits and hyphens.
std::string file_stem(std::string_view title);

// The field, what is to be said about the path in it, and the buttons; true when the file shall be written.
bool draw_save_path(const PanelContext& context);

}  // namespace ghostforce
