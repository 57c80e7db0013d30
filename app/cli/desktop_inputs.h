// The inputs of the desktop: those of every system, and the hardware. What --input, the panel Input and `doctor` know.
// Any thread; making an input allocates and may throw.
#pragma once

#include <vector>

#include "app/live/input_link.h"
#include "device/falcon_usb/ftdi_link.h"

namespace ghostforce {

class FalconInput;

// A Falcon on this cable.
InputMaker<FalconInput> falcon_kind(const FtdiLinkOptions& cable);

// In the order in which people see them.
std::vector<InputEntry> desktop_inputs(const FtdiLinkOptions& cable = {});

}  // namespace ghostforce
