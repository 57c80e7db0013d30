#include "app/session/motor_button.h"

namespace ghostforce {

namespace {

std::string_view words_in(const StageLanguage::Motors& all, const MotorReport& motors) {
  if (!motors.has_motors) return all.none;
  switch (motors.state) {
    case SafetyState::off:
      if (motors.may_still_push) return all.may_still_push;
      if (motors.reason == OffReason::key) return all.off_by_key;
      if (motors.reason != OffReason::none) return all.off;
      return motors.is_ready ? all.arm : all.not_ready;
    case SafetyState::arming:
      return motors.has_focus ? all.arming : all.arming_without_keys;
    case SafetyState::ramp:
    case SafetyState::on:
      return motors.has_focus ? all.on : all.on_without_keys;
    case SafetyState::fade:
      return all.fading;
  }
  return {};
}

}  // namespace

std::string safety_words(const MotorReport& motors, const StageLanguage& language) {
  const std::string_view reason = language.motors.reasons[static_cast<std::size_t>(motors.reason)];
  return filled(words_in(language.motors, motors), reason);
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
