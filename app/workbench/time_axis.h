// The time axis of plots over time: which times are in sight, the time under the pointer, and the moment that somebody
// looks back at. Within an ImGui frame; edits session.plots and session.stage.looks_back_to_s.
#pragma once

#include <optional>

#include "app/picture/plot_history.h"
#include "app/widgets/panel_context.h"

namespace ghostforce {

// Before the plots of a frame: the times in sight follow the newest tick, or hold the moment that is looked back at.
void bring_times_into_sight(const PanelContext& context, const PlotHistory& history);

// Within a plot, before what is plotted. `has_words`: its marks are named.
void set_up_time_axis(PlotView& view, bool has_words, float width);
// The same for the upright axis, which nobody can move.
void set_up_value_axis(double least, double greatest, float height);

// Within a plot, over what is plotted: draws the cursor, and looks back where somebody clicks. The time under the pointer,
// if it is there.
std::optional<double> draw_time_cursor(const PanelContext& context);

// After the plots: the cursor of the next frame, and whether somebody has dragged the times away from the newest.
void keep_times(PlotView& view, const PlotView& before, std::optional<double> cursor_s);

}  // namespace ghostforce
