// Words for people on the standard error. Their reader may have gone, its disk be full, or it may take nothing while
// the program is to stop: then they are lost, and nothing else changes, neither the answer nor the exit code. Any thread
// but the servo's.
#pragma once

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

}  // namespace ghostforce
