// StageAction: what a press on a part of the stage asks for, and the Action that it becomes. The button of the motors
// is among them. Values, any thread; the functions are pure, UI thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "app/state/action.h"
#include "app/state/faces_and_modes.h"
#include "app/state/stage_language.h"
#include "core/strategy.h"

namespace ghostforce {

// Something else than a strategy, a mode or a face that the stage can be asked for: the table of keys, the list of all
// actions, the menu of what else there is to do, the words and controls beside the picture, a link to what is shown, the
// full screen, the view that shows everything, the motion from its beginning, the motors on or off, the picker of lessons;
// the step before, the next step of the mode or the lesson that is on; the end of the lesson; its next language; to
// move its slider; to measure the hand, or use what was measured.
enum class StageCommand : std::uint8_t {
  keys,
  palette,
  menu,
  controls,
  link,
  full_screen,
  fit,
  reset,
  reset_all,
  motors,
  lessons,
  previous,
  next,
  leave,
  language,
  slider,
  measure
};

// An answer to a lesson's question, from 0.
enum class StageAnswer : std::uint8_t {};

// What a press on a part of the stage asks for.
using StageAction = std::variant<StrategyId, StageMode, Face, MotorsInUse, StageCommand, StageAnswer>;

// What is printed on the keys that do what some of the buttons do: they are not the same keys in every front.
struct StageKeys {
  std::string_view lessons;
  std::string_view help;
  std::string_view full_screen{};  // empty: there is no such thing here,
  std::string_view link{};         // nor a link to what is shown,
  std::string_view controls{};     // nor words and controls beside the picture
};

// What the program does for a press on a part of the stage; empty: there is nothing to do, or the part is dragged.
std::optional<Action> action_of_button(const StageAction& button, const MotorReport& motors);

// The one button of the motors: reads why they are off, arms them, turns them off, or says what is missing. What it
// does is what its words ask for.
std::string motor_words(const MotorReport& motors, const StageLanguage& language);
std::optional<Action> action_of_motor_button(const MotorReport& motors);

// What to do about motors that went off; `status_key`: of the device status. In English.
std::string remedy_words(const MotorReport& motors, std::string_view status_key);

// The keys whose names stand on the stage.
StageKeys stage_keys() noexcept;

}  // namespace ghostforce
