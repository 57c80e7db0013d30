#include "app/sweep/at_rest.h"

namespace ghostforce {

PointAtRest at_rest(const Scene& scene, const RestKind& kind) noexcept {
  const Vector<2>& goal = scene.goal.points.back();
  PointAtRest point;
  point.depth = depth(wall_of(scene.settings), goal);
  if (kind.predicted) point.predicted = predicted_rests(scene.settings, goal);
  if (kind.simulated) point.simulated = settle(scene);
  return point;
}

}  // namespace ghostforce
