#include "app/state/stage_action.h"

#include "app/state/front_keys.h"

namespace ghostforce {
namespace {

std::string_view words_in(const StageLanguage::Motors& all, const MotorReport& motors) {
  if (!motors.has_motors) return all.none;
  switch (motors.state) {
    case SafetyState::off:
      if (motors.may_still_push) return all.may_still_push;
      if (motors.reason == OffReason::key) return all.off_by_key;
      if (motors.reason != OffReason::none) return all.off;
      if (motors.waits_for_zero_pose) return all.zero_pose;
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

std::optional<Action> action_of_command(StageCommand command, const MotorReport& motors) {
  switch (command) {
    case StageCommand::keys:
      return ToggleDialog{Dialog::help};
    case StageCommand::palette:
      return ToggleDialog{Dialog::palette};
    case StageCommand::controls:
      return ShowControls{};
    case StageCommand::link:
      return ShowLink{};
    case StageCommand::full_screen:
      return ToggleFullScreen{};
    case StageCommand::fit:
      return FitView{};
    case StageCommand::reset:
      return Restart{};
    case StageCommand::reset_all:
      return Restart{.with_scene_settings = true};
    case StageCommand::motors:
      return action_of_motor_button(motors);
    case StageCommand::lessons:
      return ToggleDialog{Dialog::lessons};
    case StageCommand::previous:
      return PreviousStep{};
    case StageCommand::next:
      return GoOn{};
    case StageCommand::leave:
      return LeaveLesson{};
    case StageCommand::language:
      return NextLanguage{};
    case StageCommand::measure:
      return PressMeasuringButton{};
    case StageCommand::menu:
      return ToggleMenu{};
    case StageCommand::slider:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Action> action_of_button(const StageAction& button, const MotorReport& motors) {
  struct {
    const MotorReport& motors;

    std::optional<Action> operator()(StrategyId id) const { return ChooseStrategy{id}; }
    std::optional<Action> operator()(StageMode mode) const { return ToggleMode{mode}; }
    std::optional<Action> operator()(Face face) const { return ShowFace{face}; }
    std::optional<Action> operator()(MotorsInUse in_use) const { return UseMotors{in_use}; }
    std::optional<Action> operator()(StageAnswer answer) const {
      return AnswerLesson{static_cast<std::size_t>(answer)};
    }
    std::optional<Action> operator()(StageCommand command) const { return action_of_command(command, motors); }
  } const reader{motors};
  return std::visit(reader, button);
}

std::string motor_words(const MotorReport& motors, const StageLanguage& language) {
  const std::string_view reason = language.motors.reasons[static_cast<std::size_t>(motors.reason)];
  return filled(words_in(language.motors, motors), reason);
}

std::string remedy_words(const MotorReport& motors, std::string_view status_key) {
  const std::string_view found = sentence_of(motors.finding.verdict);
  if (motors.reason != OffReason::calibration || found.empty()) {
    return filled(entry_of(motors.reason).remedy, status_key);
  }
  return fmt::format("{} The device status ({}) says what to do.", filled(found, motors.finding.motor + 1), status_key);
}

std::optional<Action> action_of_motor_button(const MotorReport& motors) {
  if (!motors.has_motors) return std::nullopt;
  if (motors.state != SafetyState::off) return StopMotors{};
  if (motors.may_still_push) return OpenDialog{Dialog::doctor};
  // For a moment, so that a press in haste does not arm what another one has just turned off.
  if (motors.reason == OffReason::key) return std::nullopt;
  if (motors.reason != OffReason::none) return AcknowledgeOff{};
  if (motors.waits_for_zero_pose) return ConfirmZeroPose{};
  if (motors.is_ready) return ArmMotors{};
  return OpenDialog{Dialog::doctor};
}

StageKeys stage_keys() noexcept {
  const FrontKeys& keys = front_keys();
  return {.lessons = keys.lessons.shown,
          .help = keys.help.shown,
          .full_screen = keys.full_screen.shown,
          .link = keys.link.shown,
          .controls = keys.controls};
}

}  // namespace ghostforce
