// The path of a file to be saved: what is proposed, and what would happen to the one typed.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/widgets/panel_context.h"

namespace ghostforce {

// The first that is free of STEM.EXTENSION, STEM-2.EXTENSION … in the folder that the program was started in, absolute;
// where there are no folders (file_exchange.h), the name.
std::string proposed_path(std::string_view stem, std::string_view extension);

// A name for a file from a scene's title: letters, digits and hyphens.
std::string file_stem(std::string_view title);

// A choice among endings of the path, which it changes.
void draw_format_choice(std::string& path, std::span<const char* const> formats);

// Which of these endings the path has, in any case of letters; null: none of them.
const char* format_of(const std::string& path, std::span<const char* const> formats);

// The field, what is to be said about the path in it, and the buttons; true when the file shall be written.
bool draw_save_path(const PanelContext& context);

}  // namespace ghostforce
