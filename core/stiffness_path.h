// A hand that grips harder and softer: its stiffness over model time, with nodes as a scripted hand has waypoints. Asking
// it never allocates: the servo does.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ghostforce {

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

// The same hand, seen by a clock that starts then. Allocates.
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
