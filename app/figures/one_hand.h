// Figure 6: one and the same hand under the three strategies: a recorded one where there is one, else a simulated hand
// with minimum-jerk motion and tremor.
#pragma once

#include "app/figures/figure.h"
#include "app/figures/played_motion.h"

namespace ghostforce {

// Throws Failure(wrong_call) where the loop is unstable with the recording's settings.
PlayedMotion one_hand(const FigureRequest& request);
Figure one_hand_figure(const FigureRequest& request);

}  // namespace ghostforce
