// Camera: which part of the world a rectangle of the screen shows, and how close it can be so that all of some points
// are seen. Screen points have their origin at the rectangle's upper left corner, y down. Plain values; any thread.
#pragma once

#include <algorithm>
#include <span>

#include <glm/geometric.hpp>

#include "core/conventions.h"

namespace ghostforce {

struct Camera {
  Vector<2> center{0.0};          // world point in the middle of the rectangle [m]
  double points_per_metre = 1.0;  // zoom
  Vector<2> size{1.0};            // of the rectangle [points]
};

inline Vector<2> to_screen(const Camera& camera, const Vector<2>& world) noexcept {
  const Vector<2> offset = (world - camera.center) * camera.points_per_metre;
  return {0.5 * camera.size.x + offset.x, 0.5 * camera.size.y - offset.y};
}

inline Vector<2> to_world(const Camera& camera, const Vector<2>& screen) noexcept {
  const Vector<2> offset = screen - 0.5 * camera.size;
  return camera.center + Vector<2>(offset.x, -offset.y) / camera.points_per_metre;
}

// A direction on screen (y down) for one in the world (y up), same length.
inline Vector<2> to_screen_direction(const Vector<2>& world) noexcept {
  return {world.x, -world.y};
}

// As far from there as any point that it shows, and farther [m].
inline double reach_of(const Camera& camera, const Vector<2>& from) noexcept {
  return glm::length(camera.size) / camera.points_per_metre + glm::distance(camera.center, from);
}

// Shows at least `width` [m] across and three quarters of it up and down: a wide rectangle must not crop the height.
inline Camera camera_on(const Vector<2>& center, double width, const Vector<2>& size) noexcept {
  return {center, std::min(size.x / width, size.y / (0.75 * width)), size};
}

// A point of the picture that stays this far from the place of a point of the world, however close that is seen.
struct FitPoint {
  Vector<2> world;
  Vector<2> offset{0.0};  // on the screen [points], y down
};

// The greatest scale, up to `greatest`, at which the points take no more than this room [points].
double fitting_scale(std::span<const FitPoint> points, const Vector<2>& room, double greatest) noexcept;

// The middle of the points at that scale [m].
Vector<2> fitting_center(std::span<const FitPoint> points, double points_per_metre) noexcept;

}  // namespace ghostforce
