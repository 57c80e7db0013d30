// The inputs that need nothing but this program, each with its link: all of device/input_catalog.h. Any thread; making
// an input allocates and may throw.
#pragma once

#include <vector>

#include "app/live/falcon_input_link.h"

namespace ghostforce {

// In the order in which people see them.
std::vector<InputEntry> portable_inputs(const ReadinessOf& readiness_of);

}  // namespace ghostforce
