// What shows the motors' state: their button in the bar on top, a frame and words while they may push, and their heat.
#pragma once

#include "app/widgets/panel_context.h"

namespace ghostforce {

// At the right edge of the row that is being drawn; without motors only where there is room.
void draw_motor_button(const PanelContext& context, float height);

// Inside the edges of the window that is being drawn, which lies over the scene, while the motors may push.
void draw_motor_frame(const PanelContext& context);

// In the middle of the window that is being drawn, while the motors may push.
void draw_motor_words(const PanelContext& context);

// How warm the warmest motor is, as far as can be estimated: a bar, and words as wide as up to `end` of the window; 0: its
// right edge. Only with motors.
void draw_motor_heat(const PanelContext& context, float end = 0.0F);

// What it needs of the row [points]; the same in every state of the motors.
float motor_button_room(const PanelContext& context);

// The button with which a person says that the device's arms are in the zero pose, while it waits for that.
void draw_zero_pose(const PanelContext& context);

}  // namespace ghostforce
