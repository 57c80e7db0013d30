// Where a person can take hold of the scene: the arrows of the motor axis, on a dial in the lower right corner, and the
// wall near the two ends of its visible piece. The layers that draw them and the gestures that use them agree through
// this file. Screen points of a pane; pure.
#pragma once

#include <array>
#include <optional>

#include "app/picture/view.h"

namespace ghostforce {

struct MotorDial {
  Vector<2> middle;
  double radius;
};
// `unit` is the size of a point: UI scale × the theme's thickness.
MotorDial motor_dial(const Camera& camera, double unit);

// Whether the motor has one direction, wherever the handle is.
bool has_motor_dial(const Settings& settings) noexcept;

// Empty where too little of the wall is to be seen, or it is no straight one.
std::optional<std::array<Vector<2>, 2>> wall_grips(const Settings& settings, const Camera& camera, double unit);

inline constexpr double grip_radius = 7.0;  // of what is drawn [points]

// What the pointer would take hold of; more generous than what is drawn.
Handle handle_at(const Settings& settings, const Camera& camera, double unit, const Vector<2>& pointer);

// The middle that dragging the handle turns about.
Vector<2> pivot_of(Handle handle, const Settings& settings, const Camera& camera, double unit);

}  // namespace ghostforce
