#include "app/base/number.h"

#include <charconv>
#include <system_error>

namespace ghostforce {

std::optional<double> read_number(std::string_view text) noexcept {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [after, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && after == end ? std::optional(number) : std::nullopt;
}

}  // namespace ghostforce
