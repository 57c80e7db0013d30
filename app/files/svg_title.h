// The title of an SVG picture. Pure, any thread.
#pragma once

#include <string>
#include <string_view>

namespace ghostforce {

// Of the first element of that name; empty: there is none. Nothing else of the file is looked at.
std::string svg_title(std::string_view file);

}  // namespace ghostforce
