// The drawer at the bottom with the plots, key F3, and the plots themselves; and the choice of a language. Within an
// ImGui frame, UI thread.
#pragma once

#include "app/picture/trail_history.h"
#include "app/widgets/panel_context.h"

namespace ghostforce {

// Into the current ImGui window. Changes the times in sight, and settings where an operating point is dragged.
void draw_plots(const PanelContext& context, const History& history);

// Each fills what remains of the current ImGui window.
void draw_time_plots(const PanelContext& context, const PlotHistory& history);
void draw_wall_angle_plots(const PanelContext& context);
void draw_ratio_plots(const PanelContext& context);
void draw_hand_plot(const PanelContext& context, const History& history);

}  // namespace ghostforce
