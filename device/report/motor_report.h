// MotorReport: what the servo reports about the motors of an input and about their safety. Trivially copyable: it
// crosses threads whole. SI units, in the plane of the scene.
#pragma once

#include <type_traits>

#include "core/conventions.h"
#include "core/safety.h"

namespace ghostforce {

struct MotorReport {
  bool has_motors = false;  // the input has
  SafetyState state = SafetyState::off;
  OffReason reason = OffReason::none;
  OffReason last_reason = OffReason::none;  // why they went off last, acknowledged or not; none once they are on again
  ArmingObstacle obstacle = ArmingObstacle::none;
  double gain = 0.0;      // of ramp and fade
  Vector<2> handle{0.0};  // where it is, or was last known [m]
  bool is_handle_known = false;
  bool is_ready = false;         // the device, but for where its handle is
  bool is_outside_wall = false;  // the handle
  double handle_speed = 0.0;     // [m/s]
  Vector<2> sent{0.0};           // force at the handle, after every limit [N]
  bool is_saturated = false;     // the limit shortens it
  double limit = 0.0;            // in use: lower than asked for, because the motors are not known well [N]
  double held_k_r = 0.0;         // k_r is held at this while armed; 0: it is not held [N/m]
  double exchange_age_s = 0.0;   // of the newest reading
  bool is_checking = false;      // in RAMP: the device checks its motors, and nothing else pushes yet
  bool may_still_push = false;   // a device has not answered since it was told to stop, perhaps another one
  bool has_focus = true;         // keys reach the window, so that Esc turns them off
};
static_assert(std::is_trivially_copyable_v<MotorReport>);

}  // namespace ghostforce
