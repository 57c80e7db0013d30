// Figure 1: one motion from A to B into a slanted wall, and where the three devices go.
#pragma once

#include "app/figures/figure.h"
#include "app/figures/played_motion.h"

namespace ghostforce {

PlayedMotion one_motion();
Figure one_motion_figure(const FigureRequest& request);

}  // namespace ghostforce
