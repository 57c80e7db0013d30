// What a person typed: taken apart, read as a number, compared with the names that may be meant. Pure, any thread.
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <string>
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

// The text up to the separator, which is taken off `rest` with it.
inline std::string_view take_until(std::string_view& rest, char separator) noexcept {
  const std::size_t end = rest.find(separator);
  const std::string_view piece = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return piece;
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

// A number that may begin with a plus; empty: there is none.
template <typename Number>
std::optional<Number> signed_number_in(std::string_view text) noexcept {
  return number_in<Number>(text.substr(text.starts_with('+') ? 1 : 0));
}

// What a mistyped word was probably meant to be: the candidate with the fewest slips of the keyboard (a letter wrong,
// missing, too many, or two swapped; case does not count) between it and `word`; the first of equals. Empty when all
// are so far away that naming one would only confuse. A word that a candidate begins with is near, however much
// follows: k_r and k_r_N_per_m.
std::optional<std::string_view> nearest_name(std::string_view word, std::span<const std::string_view> candidates);

// "'WORD' is not one of A, B, C; did you mean 'A'?"; empty: it is one of them.
std::string not_one_of(std::string_view word, std::span<const std::string_view> words);

// "; did you mean 'CANDIDATE'?", or nothing.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace ghostforce
