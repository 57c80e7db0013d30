// A scripted hand: waypoints in time. Evaluated at t_k = k·dt, so a path has no memory and no drift.
#pragma once

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
};

// Flash & Hogan's minimum-jerk profile on 0..1: no velocity and no acceleration at either end.
inline double minimum_jerk(double s) noexcept {
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

// q_u(t) [m]. Holds the first point before, and the last one after, the path's times. The path must be valid (scene.h
// checks it). Never allocates: the servo calls it.
Vector<2> goal_at(const GoalPath& path, double time_s) noexcept;

}  // namespace ghostforce
