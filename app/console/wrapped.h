// Text in lines of a limited length. Pure, any thread.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ghostforce {

// With line breaks in place of blanks where a line would be longer than so many bytes; a longer word has a line of its
// own.
std::string wrapped(std::string_view text, std::size_t longest_line);

}  // namespace ghostforce
