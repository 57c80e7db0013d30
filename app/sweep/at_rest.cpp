#include "app/sweep/at_rest.h"

#include <utility>

namespace ghostforce {

PointsAtRest::PointsAtRest(const RestKind& kind, std::size_t expected) : kind_(kind) {
  points_.reserve(expected);
  if (kind.simulated) to_settle_.reserve(expected);
}

void PointsAtRest::add(const Scene& scene) {
  const Vector<2>& goal = scene.goal.points.back();
  PointAtRest& point = points_.emplace_back();
  point.depth = depth(wall_of(scene.settings), goal);
  if (kind_.predicted) point.predicted = predicted_rests(scene.settings, goal);
  if (kind_.simulated) to_settle_.push_back({scene.settings, scene.duration});
}

std::vector<PointAtRest> PointsAtRest::take(const GoalPath& path) {
  const std::vector<SimulatedRests> rests = settle(path, to_settle_);
  for (std::size_t i = 0; i < rests.size(); ++i) points_[i].simulated = rests[i];
  return std::move(points_);
}

PointAtRest at_rest(const Scene& scene, const RestKind& kind) {
  PointsAtRest points(kind, 1);
  points.add(scene);
  return points.take(scene.goal).front();
}

}  // namespace ghostforce
