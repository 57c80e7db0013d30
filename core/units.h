// What millimetres and degrees are in SI units: they exist in files, on the screen and in
// published angles of devices (core/conventions.h).
#pragma once

#include <numbers>

namespace ghostforce {

inline constexpr double mm_per_m = 1000.0;
inline constexpr double radians_per_degree = std::numbers::pi / 180.0;
inline constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

}  // namespace ghostforce
