// The path of a file to be saved: the field, and what would happen to the path in it.
#pragma once

#include <span>
#include <string>

#include "app/widgets/panel_context.h"

namespace ghostforce {

// A choice among endings of the path, which it changes.
void draw_format_choice(std::string& path, std::span<const char* const> formats);

// Which of these endings the path has, in any case of letters; null: none of them.
const char* format_of(const std::string& path, std::span<const char* const> formats);

// The field, what is to be said about the path in it, and the buttons; true when the file shall be written.
bool draw_save_path(const PanelContext& context);

}  // namespace ghostforce
