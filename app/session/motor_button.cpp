#include "app/session/motor_button.h"

#include <fmt/format.h>

namespace ghostforce {

std::string safety_words(const MotorReport& motors) {
  if (!motors.has_motors) return "no motor";
  switch (motors.state) {
    case SafetyState::off:
      if (motors.reason == OffReason::key) return "Motors off. Dismiss";
      if (motors.reason != OffReason::none)
        return fmt::format("Motors off: {}. Dismiss", entry_of(motors.reason).title);
      return motors.is_ready ? "Arm the motors" : "Motors not ready";
    case SafetyState::arming:
      return "Arming… Esc: off";
    case SafetyState::ramp:
    case SafetyState::on:
      return "MOTORS ON. Esc: off";
    case SafetyState::fade:
      return "MOTORS turning off";
  }
  return {};
}

bool can_press_safety_button(const MotorReport& motors) noexcept {
  return motors.has_motors && (motors.state != SafetyState::off || motors.reason != OffReason::none || motors.is_ready);
}

void press_safety_button(Session& session, const MotorReport& motors) {
  if (motors.state != SafetyState::off) {
    ++session.offs_asked;
  } else if (motors.reason != OffReason::none) {
    ++session.acknowledgements;
  } else {
    ++session.arms_asked;
  }
}

}  // namespace ghostforce
