// The inputs of the desktop: those of every system, and the hardware. What --input, the panel Input and `doctor` know.
// Any thread; making an input allocates and may throw.
#pragma once

#include <span>
#include <vector>

#include "app/shell/input_link.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/report/motor_report.h"

namespace ghostforce {

class FalconInput;

// A Falcon on this cable.
InputMaker<FalconInput> falcon_kind(const FtdiLinkOptions& cable);

// In the order in which people see them.
std::vector<InputEntry> desktop_inputs(const FtdiLinkOptions& cable = {});

// Without the hardware.
std::vector<InputEntry> simulated_inputs();

// How a run of the window ended, as far as the input's device is concerned. Pure.
// `readiness`: of the input, empty where it has none; `of_input`: what its link says.
EndOfRun end_of_run(const MotorReport& motors, std::span<const ReadinessStepState> readiness,
                        const EndOfRun& of_input);

}  // namespace ghostforce
