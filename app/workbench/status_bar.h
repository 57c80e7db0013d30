// What the bar at the bottom has to say.
#pragma once

#include <string>
#include <vector>

#include "app/state/session.h"

namespace ghostforce {

// What is not as it should be with the loop, each with what to do about it; empty: all is well.
std::vector<std::string> troubles_of(const LoopReading& loop, const Settings& settings);

}  // namespace ghostforce
