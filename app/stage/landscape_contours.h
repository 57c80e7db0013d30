// Contour lines of the landscape, by marching squares over a grid whose crossings are then found to rounding by the
// closed form. Pure, any thread.
#pragma once

#include <array>
#include <vector>

#include "app/state/landscape.h"

namespace ghostforce {

// Shares that have a line where the map reaches them [1].
inline constexpr std::array<double, 6> contour_levels{0.1, 0.5, 1.0, 2.0, -0.1, -0.5};

struct Contour {
  double level = 0.0;                  // the share along it [1]
  std::vector<LandscapePoint> points;  // in turn; a closed one ends where it begins
};

// A place on the map: (0, 0) is θ = 0° and the least κ, (1, 1) is 90° and the greatest; linear in θ and in log κ.
Vector<2> map_place(const LandscapePoint& point) noexcept;
LandscapePoint landscape_point_at(const Vector<2>& map_place) noexcept;

// Those of contour_levels that the map has, each in as many pieces as it has.
std::vector<Contour> contours_of(const Landscape& landscape);

}  // namespace ghostforce
