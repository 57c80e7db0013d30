// Force along the motor at rest over the ratio of rendering stiffness to the hand's: (11), (15), (20), and the
// simulated loop.
#pragma once

#include "app/figures/curves.h"
#include "app/figures/figure.h"

namespace ghostforce {

// x: k_r/k_u [1]; y: force along the motor, away from the wall [N].
Curves force_over_stiffness_ratio();
Figure force_over_stiffness_ratio_figure(const FigureRequest& request);

}  // namespace ghostforce
