// Fit: how close a picture can be so that all of some points are in it. Pure, any thread.
#pragma once

#include <span>

#include "core/conventions.h"

namespace ghostforce {

// A point of the picture: so far from the place of a point of the world, however close that is seen.
struct FitPoint {
  Vector<2> world;
  Vector<2> offset{0.0};  // on the screen [points], y down
};

// The greatest scale, up to a given one, at which the points take no more than this room [points].
double fitting_scale(std::span<const FitPoint> points, const Vector<2>& room, double greatest) noexcept;

// The middle of them at that scale [m].
Vector<2> fitting_center(std::span<const FitPoint> points, double points_per_metre) noexcept;

}  // namespace ghostforce
