// The quantities of the three strategies over time: four plots with one time axis and one cursor.
#pragma once

#include "app/ui/widgets/panel_context.h"
#include "app/view/plot_history.h"

namespace ghostforce {

// Fills what remains of the current ImGui window. Edits session.plots.
void draw_time_plots(const PanelContext& context, const PlotHistory& history);

}  // namespace ghostforce
