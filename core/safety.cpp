#include "core/safety.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace ghostforce {
namespace {

// In the order of OffReason.
constexpr std::array reasons{
    OffReasonEntry{OffReason::none, "none", "off", "Press the button at the top right to arm the motors.", false,
                   false},
    OffReasonEntry{OffReason::key, "key", "turned off by you",
                   "Nothing is wrong: you pressed Esc or the motors' button.", false, false},
    OffReasonEntry{OffReason::visitor_gone, "visitor_gone", "nobody there",
                   "Nothing is wrong: nobody had touched anything for a while. Arm the motors again.", false, false},
    OffReasonEntry{OffReason::button_released, "button_released", "button released",
                   "The deadman switch was released. Hold the grip button while the motors are on.", false, false},
    OffReasonEntry{OffReason::focus_lost, "focus_lost", "keys go elsewhere",
                   "Esc would not have reached this window. Click on it, or close the menu or program that has the "
                   "keyboard, then arm the motors again.",
                   false, false},
    OffReasonEntry{OffReason::too_fast, "too_fast", "too fast",
                   "The handle moved faster than 1 m/s. Hold it more firmly, or lower the rendering stiffness.", false,
                   true},
    OffReasonEntry{OffReason::over_force, "over_force", "too much force",
                   "The handle was so deep in the wall that the motors would have thrown it out. Move it out of the "
                   "wall, then arm the motors again.",
                   false, true},
    OffReasonEntry{OffReason::loop_late, "loop_late", "late answer",
                   "The device answered too late. Close other busy programs, and plug the device directly into "
                   "the computer.",
                   true, true},
    OffReasonEntry{OffReason::window_stalled, "window_stalled", "window stalled",
                   "The window did not respond for half a second, so Esc would not have worked.", false, true},
    OffReasonEntry{OffReason::unplugged, "unplugged", "unplugged",
                   "Plug the device in again. The program keeps looking for it.", true, false},
    OffReasonEntry{
        OffReason::not_homed, "not_homed", "not homed",
        "The device has lost track of its arms, for example after a power failure. Home it again, or hold its zero "
        "pose.",
        true, false},
    OffReasonEntry{OffReason::program_ending, "program_ending", "program ending", "The program was closing.", true,
                   false},
    OffReasonEntry{OffReason::overruled, "overruled", "turned off by the guard",
                   "The program did not run for 20 ms, so its guard turned the motors off. Close other busy programs, "
                   "then arm the motors again.",
                   true, true},
    OffReasonEntry{OffReason::machine_sleeps, "machine_sleeps", "computer going to sleep",
                   "Nothing is wrong: the computer was about to sleep. Arm the motors again.", false, false},
    OffReasonEntry{
        OffReason::calibration, "calibration", "motor check failed",
        "The motors did not move the handle as they were told, or the encoders did not say so. Check the "
        "power supply. Then measure the device with 'ghostforce doctor DEVICE --measure': in its calibration file a "
        "motor may have the wrong sign, or the wrong place.",
        true, false},
    OffReasonEntry{OffReason::fault, "fault", "fault", "Something failed. The device status ({}) says what.", true,
                   false},
};

// In the order of ArmingObstacle.
constexpr std::array obstacles{
    ArmingObstacleEntry{ArmingObstacle::none, ""},
    ArmingObstacleEntry{ArmingObstacle::device_not_ready, "the device is not ready; see the device status ({})"},
    ArmingObstacleEntry{ArmingObstacle::loop_not_healthy, "waiting for the device to answer quickly and steadily"},
    ArmingObstacleEntry{ArmingObstacle::inside_wall, "move the handle out of the wall"},
    ArmingObstacleEntry{ArmingObstacle::force, "hold the handle still, away from the wall"},
    ArmingObstacleEntry{ArmingObstacle::button, "hold the grip button"},
    ArmingObstacleEntry{ArmingObstacle::focus,
                        "click on this window, or close the menu or program that has the keyboard"},
};

// In the order of SafetyState.
constexpr std::array<std::string_view, 5> state_names{"OFF", "ARMING", "RAMP", "ON", "FADE"};

}  // namespace

std::span<const OffReasonEntry> off_reason_catalog() noexcept {
  return reasons;
}

const OffReasonEntry& entry_of(OffReason reason) noexcept {
  return reasons[static_cast<std::size_t>(reason)];
}

const ArmingObstacleEntry& entry_of(ArmingObstacle obstacle) noexcept {
  return obstacles[static_cast<std::size_t>(obstacle)];
}

std::string_view name_of(SafetyState state) noexcept {
  return state_names[static_cast<std::size_t>(state)];
}

void Safety::acknowledge() noexcept {
  if (state_ == SafetyState::off) reason_ = OffReason::none;
}

void Safety::turn_off(OffReason reason) noexcept {
  arm_asked_ = false;
  if (state_ == SafetyState::off) return;
  const bool at_once = entry_of(reason).at_once || gain_ == 0.0;
  if (state_ != SafetyState::fade) reason_ = last_reason_ = reason;
  if (at_once) {
    state_ = SafetyState::off;
    gain_ = 0.0;
  } else {
    state_ = SafetyState::fade;
  }
}

void Safety::update(const SafetyReading& reading, const SafetyOptions& options, double elapsed_s) noexcept {
  const double step_s = elapsed_s > 0.0 ? elapsed_s : 0.0;  // NaN: nothing has passed
  const bool arm_asked = std::exchange(arm_asked_, false);
  if (state_ == SafetyState::off && arm_asked && reason_ == OffReason::none) state_ = SafetyState::arming;
  if (state_ == SafetyState::off) return;
  if (const OffReason reason = reason_to_stop(reading, options); reason != OffReason::none) {
    // What one can wait for does not end the waiting.
    if (state_ != SafetyState::arming || reading.trouble != OffReason::none) turn_off(reason);
  }
  switch (state_) {
    case SafetyState::off:
      return;
    case SafetyState::arming:
      obstacle_ = obstacle_in(reading, options);
      if (obstacle_ != ArmingObstacle::none) return;
      state_ = SafetyState::ramp;
      last_reason_ = OffReason::none;
      return;
    case SafetyState::ramp:
      if (!reading.motors_are_checked) return;
      gain_ = std::min(1.0, gain_ + step_s / ramp_s);
      if (gain_ == 1.0) state_ = SafetyState::on;
      return;
    case SafetyState::on:
      return;
    case SafetyState::fade:
      gain_ = std::max(0.0, gain_ - step_s / fade_s);
      if (gain_ == 0.0) state_ = SafetyState::off;
      return;
  }
}

// Written so that NaN is a reason.
OffReason Safety::reason_to_stop(const SafetyReading& reading, const SafetyOptions& options) noexcept {
  if (reading.trouble != OffReason::none) return reading.trouble;
  if (!(reading.since_exchange_s <= longest_exchange_s)) return OffReason::loop_late;
  if (!(reading.since_window_s <= longest_window_s)) return OffReason::window_stalled;
  if (!reading.has_focus) return OffReason::focus_lost;
  if (options.needs_button && !reading.deadman_held) return OffReason::button_released;
  if (!(reading.speed <= greatest_speed)) return OffReason::too_fast;
  if (!(reading.wanted_force <= greatest_wanted_force)) return OffReason::over_force;
  return OffReason::none;
}

ArmingObstacle Safety::obstacle_in(const SafetyReading& reading, const SafetyOptions& options) noexcept {
  if (!reading.device_is_ready) return ArmingObstacle::device_not_ready;
  if (!reading.has_focus) return ArmingObstacle::focus;
  if (!reading.loop_is_healthy || !(reading.since_exchange_s <= longest_exchange_s) ||
      !(reading.since_window_s <= longest_window_s)) {
    return ArmingObstacle::loop_not_healthy;
  }
  if (!reading.is_outside_wall) return ArmingObstacle::inside_wall;
  if (!(reading.wanted_force < greatest_arming_force) || !(reading.speed <= greatest_speed) || !reading.is_still) {
    return ArmingObstacle::force;
  }
  if (options.needs_button && !reading.deadman_held) return ArmingObstacle::button;
  return ArmingObstacle::none;
}

}  // namespace ghostforce
