// The caption above the scene: what there is to see now, in a sentence; for a newcomer the hints.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/widgets/panel_context.h"

namespace ghostforce {

// About the active strategy under the goal as it is, by the closed forms: a motion on its way there changes nothing.
std::string_view caption_of(const Settings& settings, const Vector<2>& goal);

// What must be read even where the caption has no room: that time stands still, and what is the matter with the device.
std::vector<std::string> warnings_of_caption(const PanelContext& context);

// In the window that is current.
void draw_caption(const PanelContext& context);

}  // namespace ghostforce
