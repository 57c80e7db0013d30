// A scripted hand: where it wants the device to be, and how stiff it is, as functions of model time. They are evaluated
// at t_k = k·dt, so a path has no memory and no drift. Evaluating never allocates: the servo does it. SI units.
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

// Waypoints in time.
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
// checks it).
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

// The stiffness of a hand that grips harder and softer, with nodes as the goal has waypoints.
struct StiffnessPath {
  std::vector<double> values;  // k_u [N/m]; empty: the hand is always as stiff as the settings say
  std::vector<double> times;   // [s], strictly increasing from 0, one per value

  bool is_empty() const noexcept { return values.empty(); }
  friend bool operator==(const StiffnessPath&, const StiffnessPath&) = default;
};

// k_u(t) [N/m]: linear between the nodes, held before the first and after the last. The path must be valid (scene.h
// checks it) and not empty.
inline double stiffness_at(const StiffnessPath& path, double time_s) noexcept {
  const auto later = std::upper_bound(path.times.begin(), path.times.end(), time_s);
  if (later == path.times.begin()) return path.values.front();
  if (later == path.times.end()) return path.values.back();
  const auto to = static_cast<std::size_t>(later - path.times.begin());
  const double share = (time_s - path.times[to - 1]) / (path.times[to] - path.times[to - 1]);
  return path.values[to - 1] + share * (path.values[to] - path.values[to - 1]);
}

// The path from `time_s` on, for a clock that starts there. Allocates.
inline StiffnessPath path_since(const StiffnessPath& path, double time_s) {
  if (path.is_empty()) return {};
  StiffnessPath since{{stiffness_at(path, time_s)}, {0.0}};
  for (std::size_t i = 0; i < path.times.size(); ++i) {
    if (!(path.times[i] > time_s)) continue;
    since.values.push_back(path.values[i]);
    since.times.push_back(path.times[i] - time_s);
  }
  return since;
}

}  // namespace ghostforce
