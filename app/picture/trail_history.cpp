#include "app/picture/trail_history.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace ghostforce {

void History::clear() {
  points_.clear();
  plots_.clear();
  moments_.clear();
  hand_.clear();
}

void History::add(const Snapshot& snapshot, const Settings& settings) {
  moments_.add(snapshot, settings);
  add(snapshot);
}

void History::add(const Snapshot& snapshot) {
  plots_.add(snapshot);
  HistoryPoint point{snapshot.time_s, snapshot.goal, 0.0, {}, {}};
  for (std::size_t i = 0; i < strategy_count; ++i) point.device[i] = snapshot.strategies[i].device;
  if (points_.empty()) {
    points_.push_back(point);
    return;
  }
  const HistoryPoint& last = points_.back();
  if (point.time_s - last.time_s < least_interval_s) return;
  const double goal_step = glm::distance(point.goal, last.goal);
  bool moved = goal_step >= spacing;
  point.goal_travelled = last.goal_travelled + goal_step;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const double step = glm::distance(point.device[i], last.device[i]);
    moved = moved || step >= spacing;
    point.device_travelled[i] = last.device_travelled[i] + step;
  }
  if (!moved) return;
  points_.push_back(point);
  if (points_.size() > most_points) points_.pop_front();
}

bool History::has_trail_at(double time_s) const noexcept {
  const auto after = std::ranges::upper_bound(points_, time_s, {}, &HistoryPoint::time_s);
  // A step from one point to the next is as old as its end; one point alone is no trail.
  return after - points_.begin() > 1 && time_s - std::prev(after)->time_s < trail_lasts_s;
}

}  // namespace ghostforce
