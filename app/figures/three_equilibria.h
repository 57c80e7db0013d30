// Figure 2: the same hand at rest under each strategy: goal, device, proxy and contact.
#pragma once

#include "app/figures/figure.h"
#include "core/equilibrium.h"

namespace ghostforce {

struct ThreeEquilibria {
  Scene scene;
  PerStrategy<Equilibrium<2>> rest{};
};

ThreeEquilibria three_equilibria();
CsvTable table_of(const ThreeEquilibria& data);
Figure three_equilibria_figure(const FigureRequest& request);

}  // namespace ghostforce
