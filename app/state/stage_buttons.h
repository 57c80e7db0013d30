// What the stage's buttons and the button of the motors ask for. Pure; UI thread.
#pragma once

#include <optional>
#include <string>

#include "app/state/action.h"
#include "app/state/stage_action.h"
#include "app/state/stage_language.h"

namespace ghostforce {

// Of a press on a part of the stage; empty: there is nothing to do, or it is dragged.
std::optional<Action> action_of_button(const StageAction& button, const MotorReport& motors);

// The one button of the motors: reads why they are off, arms them, turns them off, or says what is missing. What it does
// is what its words ask for.
std::string motor_words(const MotorReport& motors, const StageLanguage& language);
std::optional<Action> action_of_motor_button(const MotorReport& motors);

// The keys whose names stand on the stage.
StageKeys stage_keys() noexcept;

}  // namespace ghostforce
