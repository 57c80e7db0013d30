// Figure 4: the stiffer the rendering against the hand, the larger the ghost force of naïve rendering.
#pragma once

#include <vector>

#include "app/figures/figure.h"
#include "app/figures/played_motion.h"

namespace ghostforce {

// k_r/k_u = 1, 5, 10, 20.
std::vector<PlayedMotion> stiffness_ratios();
Figure stiffness_ratios_figure(const FigureRequest& request);

}  // namespace ghostforce
