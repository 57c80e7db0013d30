// Why there are no steps of readiness to show, and what to do. Values; any thread.
#pragma once

#include <string>

#include "app/state/session.h"

namespace ghostforce {

// In English, whole sentences, of a LoopReading without `readiness`.
std::string why_no_readiness(const LoopReading& loop);

}  // namespace ghostforce
