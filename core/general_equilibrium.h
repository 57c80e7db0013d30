// Where everything of a general scene comes to rest under a goal that is held still, or that it comes to rest nowhere.
// Pure, never allocates or throws, any thread.
//
// At rest K_u (q_u − q_h) + f_r = 0, with the proxy and the force of round_contact.h, and rest_stability.h says that
// the handle stays there. With every motor it is the goal that is held, in closed form but for round walls. With
// fewer, which planes act and which motors are at a limit is tried in one order; within each such piece everything is
// smooth, and Newton's method finds the place of the handle, on which A depends where the mechanism turns, and that of
// the proxy, on which the tangent plane depends where the wall is round.
#pragma once

#include <optional>

#include "core/equilibrium.h"
#include "core/general_tick.h"
#include "core/prediction.h"

namespace ghostforce {

struct GeneralEquilibrium {
  Equilibrium<2> at;
  Vector<2> contact_force{0.0};  // f_c [N]
  Efforts efforts{};             // u
  std::uint8_t active = 0;       // the walls that act, bit i for wall i
};

// Empty: no rest. The fully actuated strategy has one wherever its handle can be. The cure may have none near the edge
// of the workspace, and with strings that pull against each other; naïve rendering may have none anywhere, and then
// its handle runs away. Of several it gets the one that the fully actuated rest becomes while the motors that are
// missing fade out, or the one that the handle drifts to where it does not stay there (docs/theory.md).
std::optional<GeneralEquilibrium> general_equilibrium_of(StrategyId id, const GeneralScene& scene,
                                                         const Vector<2>& goal) noexcept;

// With what it costs the hand.
struct PredictedGeneralEquilibrium {
  GeneralEquilibrium rest;
  Vector<2> ghost_force{0.0};  // f_r − A u° [N]
  Vector<2> slide{0.0};        // q_p − q_p of the fully actuated strategy [m]
};
// Of a strategy's rest, beside the fully actuated one under the same goal.
PredictedGeneralEquilibrium with_cost(const GeneralScene& scene, StrategyId id, const GeneralEquilibrium& rest,
                                      const GeneralEquilibrium& full) noexcept;
PerStrategy<std::optional<PredictedGeneralEquilibrium>> predicted_general_equilibria(const GeneralScene& scene,
                                                                                     const Vector<2>& goal) noexcept;

}  // namespace ghostforce
