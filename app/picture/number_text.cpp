#include "app/picture/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace ghostforce {
namespace {

std::string with_sign(double value, int decimals, std::string_view plus) {
  const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
  if (is_zero) return digits;
  return fmt::format("{}{}", value < 0.0 ? "−" : plus, digits);
}

}  // namespace

std::string decimal_text(double value, int decimals) {
  return with_sign(value, decimals, "");
}

std::string signed_decimal_text(double value, int decimals) {
  return with_sign(value, decimals, "+");
}

std::string deviation_text(double deviation) {
  return decimal_text(std::max(1.0, deviation), 0);
}

}  // namespace ghostforce
