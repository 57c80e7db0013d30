// A circle that a goal goes round at constant speed: the motion of the energy test. Pure, any thread.
#pragma once

#include <cmath>
#include <numbers>

#include "core/conventions.h"

namespace ghostforce {

struct Circle {
  Vector<2> center{0.0};           // [m]
  double radius = 0.0;             // [m]
  double turns_per_second = 0.25;  // counter-clockwise +, and so is the area inside [1/s]
};

// Starts at the right of the center.
inline Vector<2> position_on(const Circle& circle, double time_s) noexcept {
  const double angle = 2.0 * std::numbers::pi * circle.turns_per_second * time_s;
  return circle.center + circle.radius * Vector<2>(std::cos(angle), std::sin(angle));
}

}  // namespace ghostforce
