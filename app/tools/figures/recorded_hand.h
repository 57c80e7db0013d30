// The hand of a run, as figure 6 takes it. Pure, any thread.
#pragma once

#include <string>

#include "app/files/run.h"
#include "app/tools/figures/figure.h"

namespace ghostforce {

// `name` is what messages and the figure call the run. Throws Failure(wrong_call) where the run tells no scene, or has
// no two ticks to move between.
RecordedHand recorded_hand(const Run& run, std::string name);

}  // namespace ghostforce
