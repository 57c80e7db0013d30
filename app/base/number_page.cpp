#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

#include "app/base/number.h"

namespace ghostforce {
namespace {

// A compiler's own type, which the language does not know.
__extension__ using Wide = unsigned __int128;

constexpr int double_digits = std::numeric_limits<double>::digits;
constexpr int most_digits = 19;     // that fit into 64 bits
constexpr int greatest_power = 27;  // of five that fits into 63 bits

constexpr std::array<std::uint64_t, greatest_power + 1> powers_of_five = [] {
  std::array<std::uint64_t, greatest_power + 1> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 5 * powers[i - 1];
  return powers;
}();

// Digits and a point, then perhaps an exponent.
struct Decimal {
  bool is_number = false;
  bool is_short = true;  // `significand` holds all digits
  std::uint64_t significand = 0;
  int exponent = 0;  // of ten
};

bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

// What stands after the sign.
Decimal read_decimal(std::string_view text) noexcept {
  Decimal decimal;
  std::size_t at = 0;
  int digits = 0;  // without zeros before the first other one
  bool has_point = false;
  for (; at < text.size() && (is_digit(text[at]) || (text[at] == '.' && !has_point)); ++at) {
    if (text[at] == '.') {
      has_point = true;
      continue;
    }
    decimal.is_number = true;
    if (has_point) --decimal.exponent;
    if (digits == 0 && text[at] == '0') continue;
    if (++digits > most_digits) {
      decimal.is_short = false;
    } else {
      decimal.significand = 10 * decimal.significand + static_cast<std::uint64_t>(text[at] - '0');
    }
  }
  if (!decimal.is_number || at == text.size()) return decimal;
  decimal.is_number = false;
  if (text[at] != 'e' && text[at] != 'E') return decimal;
  ++at;
  const bool is_negative = at < text.size() && text[at] == '-';
  if (is_negative || (at < text.size() && text[at] == '+')) ++at;
  constexpr int large_enough = 100'000;
  int exponent = 0;
  for (; at < text.size() && is_digit(text[at]); ++at) {
    decimal.is_number = true;
    exponent = std::min(10 * exponent + (text[at] - '0'), large_enough);
  }
  decimal.is_number = decimal.is_number && at == text.size();
  decimal.exponent += is_negative ? -exponent : exponent;
  return decimal;
}

// `scaled` times two to the power of `exponent`, rounded once, half to even. Neither too large nor too small for that.
double rounded(Wide scaled, int exponent) noexcept {
  const auto high = static_cast<std::uint64_t>(scaled >> 64);
  const int width = high != 0 ? 64 + static_cast<int>(std::bit_width(high))
                              : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(scaled)));
  const int excess = std::max(0, width - double_digits);
  auto kept = static_cast<std::uint64_t>(scaled >> excess);
  if (excess > 0) {
    const Wide rest = scaled & ((Wide{1} << excess) - 1);
    const Wide half = Wide{1} << (excess - 1);
    if (rest > half || (rest == half && kept % 2 == 1)) ++kept;
  }
  return std::ldexp(static_cast<double>(kept), excess + exponent);
}

// Ten to the power of the exponent is two and five to it, and five's power fits into a word: so both ways are exact
// until they are rounded. That holds for nearly all numbers of a recording, and takes a twentieth of the time of strtod.
double rounded(std::uint64_t significand, int exponent) noexcept {
  if (significand == 0) return 0.0;
  if (exponent >= 0) return rounded(Wide{significand} * powers_of_five[static_cast<std::size_t>(exponent)], exponent);
  const std::uint64_t divisor = powers_of_five[static_cast<std::size_t>(-exponent)];
  const int shift = 64 + std::countl_zero(significand);
  const Wide dividend = Wide{significand} << shift;
  // What is left over counts only where the quotient's digits would be half of the last one, or even.
  const Wide quotient = dividend / divisor;
  const bool is_even = quotient * divisor == dividend;
  return rounded(is_even ? quotient : quotient | 1, exponent - shift);
}

// "inf", "infinity", "nan", "nan(any_word)".
std::optional<double> read_word(std::string_view text) noexcept {
  const auto is = [](std::string_view part, std::string_view word) {
    return std::ranges::equal(part, word, {}, [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
  };
  if (is(text, "inf") || is(text, "infinity")) return std::numeric_limits<double>::infinity();
  if (!is(text.substr(0, 3), "nan")) return std::nullopt;
  text.remove_prefix(3);
  const auto may_be_inside = [&](char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const bool is_plain = text.empty();
  const bool has_word = text.size() >= 2 && text.front() == '(' && text.back() == ')' &&
                        std::ranges::all_of(text.substr(1, text.size() - 2), may_be_inside);
  return is_plain || has_word ? std::optional(std::numeric_limits<double>::quiet_NaN()) : std::nullopt;
}

}  // namespace

std::optional<double> read_number(std::string_view text) noexcept {
  const bool is_negative = text.starts_with('-');
  const std::string_view unsigned_text = text.substr(is_negative ? 1 : 0);
  const Decimal decimal = read_decimal(unsigned_text);
  std::optional<double> number;
  if (!decimal.is_number) {
    number = read_word(unsigned_text);
  } else if (decimal.is_short && std::abs(decimal.exponent) <= greatest_power) {
    number = rounded(decimal.significand, decimal.exponent);
  } else {
    number = std::strtod(std::string(unsigned_text).c_str(), nullptr);
    const bool is_lost = *number == 0.0 && decimal.significand != 0;
    if (is_lost || std::isinf(*number)) return std::nullopt;
  }
  if (number && is_negative) number = -*number;
  return number;
}

}  // namespace ghostforce
