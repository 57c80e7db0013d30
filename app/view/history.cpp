#include "app/view/history.h"

#include <glm/geometric.hpp>

namespace ghostforce {

void History::clear() {
  points_.clear();
  plots_.clear();
}

void History::add(const Snapshot& snapshot) {
  plots_.add(snapshot);
  HistoryPoint point{snapshot.goal, 0.0, {}, {}};
  for (std::size_t i = 0; i < strategy_count; ++i) point.device[i] = snapshot.strategies[i].device;
  if (points_.empty()) {
    points_.push_back(point);
    return;
  }
  const HistoryPoint& last = points_.back();
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

}  // namespace ghostforce
