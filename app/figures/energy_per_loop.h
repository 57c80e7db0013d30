// Energy that the rendering gives to the hand on one slow closed loop inside the wall, over the tracking ratio ρ, in
// both senses: by the formula, and measured on the simulated loop.
#pragma once

#include <vector>

#include "app/figures/figure.h"
#include "core/strategy.h"

namespace ghostforce {

struct EnergyOfLoop {
  StrategyId strategy;
  double ratio;  // ρ [1]
  bool is_counter_clockwise;
  bool is_simulated;  // else by the formula, on the loop of the device at rest under each goal
  double area;        // of the device's loop, counter-clockwise + [m²]
  double energy;      // [J]
};

std::vector<EnergyOfLoop> energies_of_loops();
Figure energy_per_loop_figure(const FigureRequest& request);

}  // namespace ghostforce
