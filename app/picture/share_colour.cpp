#include "app/picture/share_colour.h"

#include <algorithm>
#include <cmath>

namespace ghostforce {
namespace {

constexpr double growth = 9.0;  // one decade of the logarithm from none to the deepest

}  // namespace

double depth_of_colour(double share) noexcept {
  const double part = std::min(std::abs(share) / deepest_share, 1.0);
  return std::log(1.0 + growth * part) / std::log(1.0 + growth);
}

double share_of_depth(double depth) noexcept {
  const double share = deepest_share * (std::pow(1.0 + growth, std::abs(depth)) - 1.0) / growth;
  return std::copysign(share, depth);
}

Colour colour_of_share(const Theme& theme, double share) noexcept {
  return mix(theme.background, share > 0.0 ? theme.excess : theme.shortfall, depth_of_colour(share));
}

std::vector<Colour> scale_of_shares(const Theme& theme, double lowest) {
  std::vector<Colour> colours;
  for (int row = 0; row < scale_rows; ++row) {
    const double depth = 1.0 + (lowest - 1.0) * (row + 0.5) / scale_rows;
    colours.push_back(colour_of_share(theme, share_of_depth(depth)));
  }
  return colours;
}

}  // namespace ghostforce
