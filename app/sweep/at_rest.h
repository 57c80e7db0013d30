// What a sweep knows about one point: where everything comes to rest, by closed form, by simulation or both. Pure, any
// thread but the servo's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "app/sweep/settle.h"
#include "core/prediction.h"
#include "core/scene.h"

namespace ghostforce {

// How the rest is found.
struct RestKind {
  std::string_view name;  // on the command line
  bool predicted;         // by closed form
  bool simulated;
};

inline constexpr std::array rest_kinds{
    RestKind{"closed-form", true, false},
    RestKind{"simulated", false, true},
    RestKind{"both", true, true},
};

struct PointAtRest {
  double depth = 0.0;                                     // of the goal, (8) [m]
  PerStrategy<PredictedRest> predicted{};                 // where the kind has it
  PerStrategy<std::optional<SimulatedRest>> simulated{};  // likewise; empty: does not come to rest
};

// Under the last waypoint of the scene's path.
PointAtRest at_rest(const Scene& scene, const RestKind& kind);

// The same for points put into one scene, one after the other; simulated side by side in the end, which is several
// times faster.
class PointsAtRest {
 public:
  // Has room for `expected` points.
  PointsAtRest(const RestKind& kind, std::size_t expected);

  // The scenes share one path.
  void add(const Scene& scene);

  // In the order of their coming. Once.
  std::vector<PointAtRest> take(const GoalPath& path);

 private:
  const RestKind& kind_;
  std::vector<PointAtRest> points_;
  std::vector<SettledPoint> to_settle_;
};

}  // namespace ghostforce
