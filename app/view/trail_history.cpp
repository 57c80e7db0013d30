#include "app/view/trail_history.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

bool is_straight(const Vector<2>& before, const Vector<2>& point, const Vector<2>& after) {
  const Vector<2> piece = after - before;
  const double length = glm::length(piece);
  if (length > History::longest_piece) return false;
  const double share = length > 0.0 ? glm::clamp(glm::dot(point - before, piece) / (length * length), 0.0, 1.0) : 0.0;
  return glm::distance(point, before + share * piece) <= History::straightness;
}

bool is_straight(const HistoryPoint& before, const HistoryPoint& point, const HistoryPoint& after) {
  bool result = is_straight(before.goal, point.goal, after.goal);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    result = result && is_straight(before.device[i], point.device[i], after.device[i]);
  }
  return result;
}

}  // namespace

void History::clear() {
  points_.clear();
  plots_.clear();
  moments_.clear();
}

void History::add(const Snapshot& snapshot, const Settings& settings) {
  moments_.add(snapshot, settings);
  add(snapshot);
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
  thin_out();
  if (points_.size() > most_points) points_.pop_front();
}

// Looks at the one point that has just become old.
void History::thin_out() {
  if (points_.size() < dense_points + 2) return;
  const auto aging = points_.end() - static_cast<std::ptrdiff_t>(dense_points) - 1;
  if (is_straight(*(aging - 1), *aging, *(aging + 1))) points_.erase(aging);
}

}  // namespace ghostforce
