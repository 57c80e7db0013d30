// The motors' button in the bar on top.
#pragma once

#include "app/ui/widgets/panel_context.h"

namespace ghostforce {

// At the right edge of the row that is being drawn; without motors only where there is room.
void draw_motor_button(const PanelContext& context, float height);

// In the middle of the window that is being drawn, while the motors may push.
void draw_motor_words(const PanelContext& context);

// What it needs of the row [points]; the same in every state of the motors.
float motor_button_room(const PanelContext& context);

}  // namespace ghostforce
