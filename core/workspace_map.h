// Which walls are bad for a device: what a strategy does at a wall of some direction, for each place of the handle. The
// handle is at rest there with the hand so deep in the wall; everything follows in closed form, because A is that of the
// place. Pure, never allocates or throws, any thread.
//
//     f     = A u with the proxy on a wall through which the handle is pushed by s; f grows with s
//     depth = s + n·C_u f                                    of the hand, which tells s
//     f°    = depth/(n·(C_u/τ + C_r/τ)n + 1/k_c) n/τ         fully actuated, under the same hand
//     share = |f − A u°|/|f°|
//
// Whether it stays there, rest_stability.h tells.
#pragma once

#include <cstdint>

#include "core/general_tick.h"

namespace ghostforce {

struct WallAtPose {
  enum class Rest : std::uint8_t {
    unreachable,  // the handle cannot be there
    stays,
    runs_away
  };
  Rest rest = Rest::unreachable;
  double ghost_share = 0.0;  // of the push that the wall should give [1]
  Vector<2> motor{0.0};      // the unit direction in which the first motor pushes
};

// `normal`: outward and of unit length; `depth`: of the hand in the wall, positive [m]. For devices whose motors have no
// limits: arms, pantographs, axes.
WallAtPose wall_at_pose(const GeneralScene& scene, StrategyId id, const Vector<2>& handle, const Vector<2>& normal,
                        double depth) noexcept;

}  // namespace ghostforce
