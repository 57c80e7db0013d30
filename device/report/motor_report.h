// What a device with motors reports: the motors and their safety, and how far it is from pushing. MotorReport is trivially
// copyable: it crosses threads whole. SI units, in the plane of the scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/conventions.h"
#include "core/mechanism.h"
#include "core/motor_heat.h"
#include "core/motor_verdict.h"
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
  bool is_ready = false;                 // the device, but for where its handle is
  bool is_outside_wall = false;          // the handle
  double handle_speed = 0.0;             // [m/s]
  Vector<2> sent{0.0};                   // force at the handle, after every limit [N]
  bool is_saturated = false;             // a limit shortens it
  bool motor_is_at_limit = false;        // and that is what a motor can give at most
  double limit = 0.0;                    // in use: lower than asked for, because the motors are not known well [N]
  double held_k_r = 0.0;                 // k_r is held at this while armed; 0: it is not held [N/m]
  double exchange_age_s = 0.0;           // of the newest reading
  bool is_checking = false;              // in RAMP: the device checks its motors, and nothing else pushes yet
  MotorFinding finding{};                // of that check when it ended last, where the device tells
  bool may_still_push = false;           // a device has not answered since it was told to stop, perhaps another one
  bool has_focus = true;                 // keys reach the window, so that Esc turns them off
  MotorHeats heat{};                     // estimated (core/motor_heat.h)
  bool zero_pose_moved = false;          // one has said so, and they were moving
  bool waits_for_zero_pose = false;      // a person has to say that the arms are there
  bool line_turns = false;               // with the handle: the line of the motor that pushes alone
  double line_angle = 0.0;               // then: its direction now [rad]
  std::size_t pushing_motor = 0;         // and which of two motors that is, 0 or 1
  std::optional<LinkagePose> linkage{};  // of a device whose links move in the plane, as they stand

  // The motors give all that they are asked for.
  bool gives_all() const noexcept { return !is_saturated && gain == 1.0; }
};
static_assert(std::is_trivially_copyable_v<MotorReport>);

// What lies between a device in its box and one that pushes, in the order in which the steps are reached.
enum class ReadinessStep : std::uint8_t {
  seen,
  allowed,
  free,
  firmware,
  homed,
  encoders_move,
  fast_enough,
  outside_wall,
  armed,
};

// How a step stands, as app/tools/doctor/readiness.h finds it out.
struct ReadinessStepState {
  ReadinessStep step = ReadinessStep::seen;
  std::string_view name;   // in JSON
  std::string_view title;  // on screen: what is so, or is still to come
  bool is_reached = false;
  bool is_current = false;  // the first that is not reached
  std::string words;        // whole sentences: what is so, and what to do; empty: its turn has not come
};

}  // namespace ghostforce
