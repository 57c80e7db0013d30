// What a sweep knows about one point: where everything comes to rest, by closed form, by simulation or both. Pure, any
// thread but the servo's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/general_equilibrium.h"
#include "core/prediction.h"
#include "core/scene.h"
#include "core/strategy.h"

namespace ghostforce {

// Where the simulated devices come to rest: the scene's scripted hand, tick by tick, then held still until the devices
// stand still too. Many settings side by side (core/batch.h), on the calling thread.
struct SimulatedEquilibrium {
  Vector<2> device{0.0};  // q_h [m]
  Vector<2> proxy{0.0};   // q_p [m]
  Vector<2> force{0.0};   // f_r [N]
  Efforts efforts{};      // u, in general scenes [N or N·m]
};

// Ticks that the hand is held still at most while the devices come to rest: 1000 s at 1 kHz. A device that creeps needs
// some 25 times b / k_u, which is 0.05 s in the shipped scenes.
inline constexpr std::int64_t most_held_ticks = 1'000'000;

// The hand follows the scene's path to its end, or to the scene's duration if that is shorter, and stays at the last
// waypoint from there. There the devices are nudged by a nanometre, off both axes: what is stable forgets that.
//
// A device is at rest when the forces on it cancel, |k_u (q_u − q_h) + f_r| ≤ F, and it moves no more, √(k_u m) |v| ≤
// F. Both are needed: a slow device is not yet there, and a swinging one passes through the balance. F is what the
// hand's spring makes of a picometre, a hundred-millionth of what a Falcon's encoder can tell, and what rounding
// leaves: the positions are known to some ulp, and the stiffnesses make forces of that.
//
// Empty for a strategy that does not come to rest: its loop is unstable, or goes on swinging against the wall, or takes
// longer than most_held_ticks.
using SimulatedEquilibria = PerStrategy<std::optional<SimulatedEquilibrium>>;

// What of a scene may differ between those that are simulated together.
struct SimulatedPoint {
  Settings settings;
  double duration;  // of the scene [s]
};

// Not a bit of a point's result depends on the others; together they are several times faster.
std::vector<SimulatedEquilibria> simulate_to_equilibrium(const GoalPath& path, std::span<const SimulatedPoint> points);

// The same for a general scene, with the loop that the servo has. A device outside its workspace is not at rest there.
SimulatedEquilibria simulate_general_to_equilibrium(const GoalPath& path, const SimulatedPoint& point);

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
  double depth = 0.0;                             // of the goal, (8) [m]
  PerStrategy<PredictedEquilibrium> predicted{};  // where the kind has it
  // Instead of that in general scenes; empty: no rest.
  PerStrategy<std::optional<PredictedGeneralEquilibrium>> general{};
  bool is_general = false;
  std::size_t motors = 0;                                        // in general scenes
  PerStrategy<std::optional<SimulatedEquilibrium>> simulated{};  // likewise; empty: does not come to rest
};

// Points put into one scene, one after the other; simulated side by side in the end, which is several times faster.
class PointEquilibria {
 public:
  // Has room for `expected` points. `are_general`: they are asked what general scenes are asked.
  PointEquilibria(const EquilibriumKind& kind, std::size_t expected, bool are_general = false);

  // The scenes share one path.
  void add(const Scene& scene);

  // In the order of their coming. Once.
  std::vector<PointEquilibrium> take(const GoalPath& path);

 private:
  const EquilibriumKind& kind_;
  bool are_general_;
  std::vector<PointEquilibrium> points_;
  std::vector<SimulatedPoint> to_simulate_;
};

}  // namespace ghostforce
