// A scripted hand: waypoints in time. Evaluated at t_k = k·dt, so a path has no memory and no drift.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/conventions.h"

namespace ghostforce {

enum class Motion : std::uint8_t {
  linear,        // constant velocity between waypoints
  minimum_jerk,  // smooth start and stop at each waypoint, as a human hand moves
};

struct GoalPath {
  std::vector<Vector<2>> points;  // [m], one or more
  std::vector<double> times;      // [s], strictly increasing from 0, one per point
  Motion motion = Motion::linear;

  friend bool operator==(const GoalPath&, const GoalPath&) = default;
};

// Flash & Hogan's minimum-jerk profile on 0..1: no velocity and no acceleration at either end.
inline double minimum_jerk(double s) noexcept {
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

// q_u(t) [m]. Holds the first point before, and the last one after, the path's times. The path must be valid (scene.h
// checks it). Never allocates: the servo calls it.
inline Vector<2> goal_at(const GoalPath& path, double time_s) noexcept {
  const auto later = std::upper_bound(path.times.begin(), path.times.end(), time_s);
  if (later == path.times.begin()) return path.points.front();
  if (later == path.times.end()) return path.points.back();
  const auto to = static_cast<std::size_t>(later - path.times.begin());
  const std::size_t from = to - 1;
  const double share = (time_s - path.times[from]) / (path.times[to] - path.times[from]);
  const double progress = path.motion == Motion::linear ? share : minimum_jerk(share);
  return path.points[from] + progress * (path.points[to] - path.points[from]);
}

}  // namespace ghostforce
