#include "app/sweep/point_equilibrium.h"

#include <utility>

namespace ghostforce {

PointEquilibria::PointEquilibria(const EquilibriumKind& kind, std::size_t expected) : kind_(kind) {
  points_.reserve(expected);
  if (kind.simulated) to_simulate_.reserve(expected);
}

void PointEquilibria::add(const Scene& scene) {
  const Vector<2>& goal = scene.goal.points.back();
  PointEquilibrium& point = points_.emplace_back();
  point.depth = depth(wall_of(scene.settings), goal);
  const Settings at_end = settings_at(scene, scene.settings, scene.duration);
  if (kind_.predicted) point.predicted = predicted_equilibria(at_end, goal);
  if (kind_.simulated) to_simulate_.push_back({at_end, scene.duration});
}

std::vector<PointEquilibrium> PointEquilibria::take(const GoalPath& path) {
  const std::vector<SimulatedEquilibria> equilibria = simulate_to_equilibrium(path, to_simulate_);
  for (std::size_t i = 0; i < equilibria.size(); ++i) points_[i].simulated = equilibria[i];
  return std::move(points_);
}

}  // namespace ghostforce
