// Force along the motor at rest over the angle between wall normal and motor axis: (11), (15), (20), and the simulated
// loop.
#pragma once

#include "app/figures/curves.h"
#include "app/figures/figure.h"

namespace ghostforce {

// x: angle [°]; y: force along the motor, away from the wall [N].
Curves force_over_wall_angle();
Figure force_over_wall_angle_figure(const FigureRequest& request);

}  // namespace ghostforce
