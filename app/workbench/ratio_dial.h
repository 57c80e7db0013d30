// The ρ dial: one track from naïve (ρ = 1) to the optimal ratio ρ* and beyond. The two underactuated strategies are the
// ends of this one dial.
#pragma once

#include "app/widgets/panel_context.h"

namespace ghostforce {

// Edits stiffnesses.chosen_tracking_ratio; near ρ* it snaps to "optimal", which then follows k_r and the believed k_u.
void draw_ratio_dial(const PanelContext& context);

// The ratios that a plot over them shows: naïve and optimal in the middle of it, and the one in use always in sight.
struct RatioRange {
  double least;
  double greatest;
};
RatioRange ratio_range(const Stiffnesses& stiffnesses);

// As a person who drags means it: near ρ* the optimal ratio from now on, near 1 exactly naïve, else this one. `snap` is
// how near, as a difference of logarithms.
inline constexpr float ratio_snap_points = 7.0F;  // that near under the pointer
Stiffnesses with_ratio(Stiffnesses stiffnesses, double ratio, double snap);

}  // namespace ghostforce
