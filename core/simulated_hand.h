// A simulated hand: smooth motion between waypoints, and the tremor that every hand has. The same seed gives the same
// hand on every machine. Pure; allocates, so not for the servo thread.
#pragma once

#include <cstdint>

#include "core/goal_path.h"

namespace ghostforce {

// Physiological tremor: a hand held still shakes at 8 to 12 Hz, by a few tenths of a millimetre.
struct Tremor {
  double rms = 0.0002;  // of each axis [m]
  double least_hz = 8.0;
  double greatest_hz = 12.0;
  std::uint64_t seed = 1;
};

// One waypoint per tick, from 0 to `duration_s`, both included: minimum jerk between the waypoints of `aim`, whatever
// its own motion is, and then held; plus the tremor. `rate` [Hz].
GoalPath simulated_hand(const GoalPath& aim, const Tremor& tremor, double duration_s, double rate);

}  // namespace ghostforce
