// Rest curves: where everything would come to rest if one setting were another, by closed form: what the plots over the
// wall's angle and over the tracking ratio show. Pure, any thread.
#pragma once

#include <vector>

#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

// Signed, so that a curve crosses 0 where it changes sides.
struct EquilibriumValue {
  double force = 0.0;  // along the actuated direction [N]
  double drift = 0.0;  // of the proxy, along the wall; + is to the left of its normal [m]
};

struct EquilibriumCurves {
  std::vector<double> at;  // the setting's values, rising
  PerStrategy<std::vector<EquilibriumValue>> values;
};

// Under which settings and which goal things come to rest.
struct EquilibriumQuestion {
  Settings settings;
  Vector<2> goal{0.0};            // [m]
  bool goal_is_inferred = false;  // then nobody knows how far the proxy is beside it: drifts are NaN
};

// Of this moment. The goal of a real hand is inferred with the stiffness that the hand is believed to have, and so that
// is the hand's stiffness then.
EquilibriumQuestion equilibrium_question(const Settings& settings, const Snapshot& snapshot) noexcept;

EquilibriumValue equilibrium_value(StrategyId id, const EquilibriumQuestion& question) noexcept;

// The same of a tick: of a snapshot's force and drift.
EquilibriumValue value_now(const Vector<2>& force, const Vector<2>& drift, const Settings& settings) noexcept;

// The goal that a wall at another angle has at the same depth and at the same place along it [m].
Vector<2> goal_turned_with_wall(const Settings& settings, const Vector<2>& goal, double wall_normal_angle) noexcept;

// Over the angle of the wall's normal, a whole turn from 0 [rad]: the wall turns about its point, and the goal keeps
// the depth that it has, as in the paper's figure. `count` ≥ 2.
EquilibriumCurves equilibria_over_wall_angle(const EquilibriumQuestion& question, std::size_t count);

// Over the tracking ratio ρ from `least` to `greatest`, in equal steps of its logarithm. Only the anisotropic strategy
// has one: it is the naïve one at 1, and pushes like the fully actuated one at ρ*. `count` ≥ 2.
EquilibriumCurves equilibria_over_ratio(const EquilibriumQuestion& question, double least, double greatest,
                                        std::size_t count);

}  // namespace ghostforce
