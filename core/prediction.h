// Where the devices come to rest by closed form, with what it costs the hand: what `equilibrium` and `sweep` report.
// Pure, any thread; allocates nothing.
#pragma once

#include "core/ghost_force.h"
#include "core/settings.h"

namespace ghostforce {

struct PredictedEquilibrium {
  Equilibrium<2> at;
  Vector<2> ghost_force{0.0};  // [N]
  Vector<2> proxy_drift{0.0};  // [m]
};

// Under a goal that is held still.
inline PerStrategy<PredictedEquilibrium> predicted_equilibria(const Settings& settings,
                                                              const Vector<2>& goal) noexcept {
  const Wall<2> wall = wall_of(settings);
  const Actuation<2> actuation = actuation_of(settings);
  PerStrategy<PredictedEquilibrium> equilibria;
  for (const Strategy& strategy : strategy_catalog()) {
    equilibria[index_of(strategy.id)].at = equilibrium_of(strategy, wall, actuation, settings.stiffnesses, goal);
  }
  const Vector<2> full_force = equilibria[index_of(StrategyId::full)].at.force;
  for (PredictedEquilibrium& rest : equilibria) {
    rest.ghost_force = ghost_force(actuation, rest.at.force, full_force);
    rest.proxy_drift = proxy_drift(wall, rest.at.proxy, goal);
  }
  return equilibria;
}

}  // namespace ghostforce
