// The titles of pictures in files. Pure, any thread.
#pragma once

#include <string>
#include <string_view>

namespace ghostforce {

// Of the first element of that name; empty: there is none. Nothing else of the file is looked at.
std::string svg_title(std::string_view file);

// Of the document, where it stands in the file as plain text (up to version 1.4 it always does); empty: there is none, or
// it is packed away. Letters beyond ASCII come out as '?'.
std::string pdf_title(std::string_view file);

}  // namespace ghostforce
