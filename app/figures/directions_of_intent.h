// Figure 3: three directions in which the hand wants to go: without a motor, into the wall, along the motor.
#pragma once

#include <vector>

#include "app/figures/figure.h"
#include "app/figures/played_motion.h"

namespace ghostforce {

std::vector<PlayedMotion> directions_of_intent();
Figure directions_of_intent_figure(const FigureRequest& request);

}  // namespace ghostforce
