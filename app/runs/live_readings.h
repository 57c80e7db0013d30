// How stiff the hand of a run was while tones measured it: the estimates that the servo makes live (core/hand_estimator.h),
// made once more of a recording. Pure, any thread.
#pragma once

#include <vector>

#include "app/files/run.h"
#include "core/hand_estimator.h"

namespace ghostforce {

struct LiveReading {
  double time_s = 0.0;  // model time, at the end of the window
  HandEstimate estimate;
};

// Every HandEstimator::period_s from when there can be a window, in a run that must tell its scene. Of a run without tones,
// or that is shorter than a window, a single one at its end, which says so.
std::vector<LiveReading> live_readings(const Run& run);

// Some of it was measured by tones, whether the hand is known or not.
bool has_tones(const Run& run) noexcept;

}  // namespace ghostforce
