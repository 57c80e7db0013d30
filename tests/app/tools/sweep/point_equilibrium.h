// One point of a sweep, by itself.
#pragma once

#include "app/tools/sweep/point_equilibrium.h"

namespace ghostforce {

inline PointEquilibrium point_equilibrium(const Scene& scene, const EquilibriumKind& kind) {
  PointEquilibria points(kind, 1);
  points.add(scene);
  return points.take(scene.goal).front();
}

}  // namespace ghostforce
