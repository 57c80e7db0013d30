#include "core/goal_path.h"

#include <algorithm>
#include <cstddef>

namespace ghostforce {
Vector<2> goal_at(const GoalPath& path, double time_s) noexcept {
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
