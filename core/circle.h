// A circle that a goal goes round at constant speed: the motion of the energy test. Pure, any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/wall.h"

namespace ghostforce {

struct Circle {
  Vector<2> center{0.0};           // [m]
  double radius = 0.0;             // [m]
  double turns_per_second = 0.25;  // counter-clockwise +, and so is the area inside [1/s]

  friend bool operator==(const Circle&, const Circle&) = default;
};

// Starts at the right of the center.
inline Vector<2> position_on(const Circle& circle, double time_s) noexcept {
  const double angle = 2.0 * std::numbers::pi * circle.turns_per_second * time_s;
  return circle.center + circle.radius * Vector<2>(std::cos(angle), std::sin(angle));
}

// What a person may choose of it.
struct CircleChoice {
  std::optional<double> radius;  // [m]; empty: half of the depth that there is, within reason
  bool is_clockwise = false;

  friend bool operator==(const CircleChoice&, const CircleChoice&) = default;
};

// A circle that lies inside the wall, all of it at least a quarter of its radius deep, round `near`, or, where that is
// not deep enough, round the nearest point behind it, along the normal, that is.
inline Circle circle_inside(const Wall<2>& wall, const Vector<2>& near, const CircleChoice& choice) noexcept {
  constexpr double least = 0.005;
  constexpr double greatest = 0.020;
  constexpr double clearance = 0.25;
  const double radius = choice.radius.value_or(std::clamp(0.5 * depth(wall, near), least, greatest));
  const double missing = (1.0 + clearance) * radius - depth(wall, near);
  Circle circle{near - wall.normal * std::max(missing, 0.0), radius};
  if (choice.is_clockwise) circle.turns_per_second = -circle.turns_per_second;
  return circle;
}

}  // namespace ghostforce
