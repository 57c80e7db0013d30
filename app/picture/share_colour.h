// How a ghost force is coloured on maps: as a share of the push that a wall should give. Pure, any thread.
#pragma once

#include <vector>

#include "app/picture/theme.h"

namespace ghostforce {

inline constexpr double deepest_share = 3.0;  // and all beyond [1]

// How deep a share's colour is, from 0 to 1: quick at first, since the first tenths are what is felt first.
double depth_of_colour(double share) noexcept;
// The inverse, with the sign.
double share_of_depth(double depth) noexcept;

// Too much has another colour than too little.
Colour colour_of_share(const Theme& theme, double share) noexcept;

// Of a scale, from the deepest above to the depth `lowest` below: 0, or less where there is too little.
inline constexpr int scale_rows = 64;
std::vector<Colour> scale_of_shares(const Theme& theme, double lowest);

}  // namespace ghostforce
