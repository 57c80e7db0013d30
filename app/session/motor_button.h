// The one button of the motors: reads why they are off, arms them, or turns them off. UI thread.
#pragma once

#include <string>

#include "app/session/session.h"

namespace ghostforce {

// What it says; pressed, it does what its words ask for.
std::string safety_words(const MotorReport& motors, const StageLanguage& language);
// False where there is nothing to do.
bool can_press_safety_button(const MotorReport& motors) noexcept;
void press_safety_button(Session& session, const MotorReport& motors);

}  // namespace ghostforce
