// How a visit at the window ended, as far as the input's device is concerned: for scripts a number, for the people who
// read their logs a sentence. Pure, allocates; not for the servo thread.
#pragma once

#include <string>

#include "app/console/failure.h"
#include "core/motor_report.h"
#include "core/spacemouse.h"
#include "device/falcon/falcon_report.h"

namespace ghostforce {

struct EndOfVisit {
  ExitCode code = ExitCode::done;
  std::string words;  // empty where all went well
};

// `falcon` and `spacemouse`: null where the input is another.
EndOfVisit end_of_visit(const MotorReport& motors, const FalconReport* falcon, const SpaceMouseReading* spacemouse);

}  // namespace ghostforce
