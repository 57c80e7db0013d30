// How a visit at the window ended, as far as the input's device is concerned. Pure, allocates; not for the servo
// thread.
#pragma once

#include <span>

#include "app/live/input_link.h"
#include "core/motor_report.h"

namespace ghostforce {

// `readiness`: of the input, empty where it has none; `of_input`: what its link says.
EndOfVisit end_of_visit(const MotorReport& motors, std::span<const ReadinessStepState> readiness,
                        const EndOfVisit& of_input);

}  // namespace ghostforce
