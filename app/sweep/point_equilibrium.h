// What a sweep knows about one point: where everything comes to rest, by closed form, by simulation or both. Pure, any
// thread but the servo's.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "app/sweep/simulate_to_equilibrium.h"
#include "core/prediction.h"
#include "core/scene.h"

namespace ghostforce {

// How the rest is found.
struct EquilibriumKind {
  std::string_view name;  // on the command line
  bool predicted;         // by closed form
  bool simulated;
};

inline constexpr std::array equilibrium_kinds{
    EquilibriumKind{"closed-form", true, false},
    EquilibriumKind{"simulated", false, true},
    EquilibriumKind{"both", true, true},
};

// Under the last waypoint of the scene's path.
struct PointEquilibrium {
  double depth = 0.0;                                            // of the goal, (8) [m]
  PerStrategy<PredictedEquilibrium> predicted{};                 // where the kind has it
  PerStrategy<std::optional<SimulatedEquilibrium>> simulated{};  // likewise; empty: does not come to rest
};

// Points put into one scene, one after the other; simulated side by side in the end, which is several times faster.
class PointEquilibria {
 public:
  // Has room for `expected` points.
  PointEquilibria(const EquilibriumKind& kind, std::size_t expected);

  // The scenes share one path.
  void add(const Scene& scene);

  // In the order of their coming. Once.
  std::vector<PointEquilibrium> take(const GoalPath& path);

 private:
  const EquilibriumKind& kind_;
  std::vector<PointEquilibrium> points_;
  std::vector<SimulatedPoint> to_simulate_;
};

}  // namespace ghostforce
