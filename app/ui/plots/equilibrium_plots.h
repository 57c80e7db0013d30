// Force and drift at rest over one setting: the wall's angle, or the tracking ratio. The curves are the closed forms,
// rings mark them at the setting in use, shapes what the simulation does there. The operating point can be dragged, and
// the scene follows.
#pragma once

#include "app/ui/widgets/panel_context.h"

namespace ghostforce {

// Each fills what remains of the current ImGui window, and edits session.settings.
void draw_wall_angle_plots(const PanelContext& context);
void draw_ratio_plots(const PanelContext& context);

}  // namespace ghostforce
