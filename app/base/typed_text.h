// What a person typed, taken apart. Pure, any thread.
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "app/base/number.h"

namespace ghostforce {

// Without the blanks around it.
inline std::string_view trimmed(std::string_view text) noexcept {
  constexpr std::string_view blanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

// A number, and nothing but it; empty: there is none. `base`: of a whole number, if not 10.
template <typename Number, typename... Base>
std::optional<Number> number_in(std::string_view text, Base... base) noexcept {
  if constexpr (std::is_same_v<Number, double>) {
    return read_number(text, base...);
  } else {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [after, error] = std::from_chars(text.data(), end, number, base...);
    return error == std::errc{} && after == end ? std::optional(number) : std::nullopt;
  }
}

// The same of one that may begin with a plus.
template <typename Number>
std::optional<Number> signed_number_in(std::string_view text) noexcept {
  return number_in<Number>(text.substr(text.starts_with('+') ? 1 : 0));
}

}  // namespace ghostforce
