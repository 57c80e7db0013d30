// Words for people on the standard error. Their reader may have gone, or its disk be full: then they are lost, and
// nothing else changes, neither the answer nor the exit code. Any thread but the servo's.
#pragma once

#include <cstdio>
#include <string>
#include <utility>

#include <fmt/format.h>

namespace ghostforce {

template <typename... Values>
void say(fmt::format_string<Values...> format, Values&&... values) {
  const std::string words = fmt::format(format, std::forward<Values>(values)...);
  std::fwrite(words.data(), 1, words.size(), stderr);
}

}  // namespace ghostforce
