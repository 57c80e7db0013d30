// Words for people on the standard error. Their reader may have gone, its disk be full, or it may take nothing while
// the program is to stop: then they are lost, and nothing else changes, neither the answer nor the exit code. Any thread
// but the servo's.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace ghostforce {

// As they are.
void write_words(std::string_view words) noexcept;

template <typename... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  write_words(fmt::format(format, std::forward<Values>(values)...));
}

// With line breaks in place of blanks where a line would be longer than so many bytes; a longer word has a line of its
// own. `indent` stands before each line but the first, and does not count.
std::string wrapped(std::string_view text, std::size_t longest_line, std::string_view indent = {});

}  // namespace ghostforce
