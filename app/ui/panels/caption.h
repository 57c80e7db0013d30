// The caption above the scene: what there is to see now, in a sentence; for a newcomer the hints.
#pragma once

#include "app/ui/widgets/panel_context.h"

namespace ghostforce {

// About the active strategy under the goal as it is, by the closed forms: a motion on its way there changes nothing.
std::string_view caption_of(const Settings& settings, const Vector<2>& goal);

// In the window that is current.
void draw_caption(const PanelContext& context);

}  // namespace ghostforce
