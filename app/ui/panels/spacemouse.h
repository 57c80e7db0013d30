// What the panel Input shows of a SpaceMouse: which it is, or why there is none; its cap, live; its settings, which are
// the session's.
#pragma once

#include "app/ui/widgets/panel_context.h"

namespace ghostforce {

void draw_spacemouse(const PanelContext& context, const SpaceMouseReading& reading);

}  // namespace ghostforce
