// Where the devices come to rest by closed form, with what it costs the hand: what `equilibrium` and `sweep` tell.
// Pure, any thread; allocates nothing.
#pragma once

#include "core/equilibrium.h"
#include "core/settings.h"
#include "core/strategy.h"

namespace ghostforce {

struct PredictedEquilibrium {
  Equilibrium<2> at;
  Vector<2> ghost_force{0.0};  // [N]
  Vector<2> proxy_drift{0.0};  // [m]
};

// Under a goal that is held still.
PerStrategy<PredictedEquilibrium> predicted_equilibria(const Settings& settings, const Vector<2>& goal) noexcept;

}  // namespace ghostforce
