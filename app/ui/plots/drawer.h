// The drawer at the bottom with the plots, key F3.
#pragma once

#include "app/ui/widgets/panel_context.h"
#include "app/view/plot_history.h"

namespace ghostforce {

// Into the current ImGui window. Edits session.plots, and settings where an operating point is dragged.
void draw_plots(const PanelContext& context, const PlotHistory& history);

}  // namespace ghostforce
