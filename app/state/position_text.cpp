#include "app/state/position_text.h"

#include <cmath>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/scene_file.h"
#include "core/units.h"

namespace ghostforce {

std::optional<Vector<2>> read_position_mm(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = signed_number_in<double>(text.substr(0, comma));
  const auto y = signed_number_in<double>(text.substr(comma + 1));
  const auto fits = [](const std::optional<double>& mm) { return mm && std::abs(*mm) <= farthest_mm; };
  return fits(x) && fits(y) ? std::optional(Vector<2>(*x / mm_per_m, *y / mm_per_m)) : std::nullopt;
}

std::string no_position_words(std::string_view option, std::string_view text) {
  return fmt::format("{}: not a position; give two numbers from {} to {} mm, as in {}=-10,5", quoted_text(text),
                     -farthest_mm, farthest_mm, option);
}

std::string position_mm_text(const Vector<2>& position) {
  return fmt::format("{},{}", file_millimetres(position.x), file_millimetres(position.y));
}

}  // namespace ghostforce
