// The examination of a Falcon, real or virtual: driven as in the window, by the same input, up to the last step that
// needs no wall, with its motors off all the time. Takes seconds; the thread that calls it drives the device.
#pragma once

#include <functional>

#include "device/falcon/falcon_input.h"

namespace ghostforce {

// Looks once whether the device is there, gives it firmware if it has none, waits up to `wait_s` until a person has
// homed it and moved its handle, and measures its exchanges for a second. Ends earlier where a fault ends it. `watch`
// sees every reading and may throw. Returns the last report before the device was let go.
FalconReport examine(FalconInput& falcon, double wait_s, const std::function<void(const FalconReport&)>& watch);

}  // namespace ghostforce
