// Where a run's hand begins when it is played once more: from the state that was recorded, where that holds, else at
// rest. Pure, any thread.
#pragma once

#include "app/run_reader.h"
#include "core/tick.h"

namespace ghostforce {

// The state of a tick that has one. Strategies without a row stay at 0.
TickState<2> recorded_state(const RunTick& tick, const RunState& state);

// k = 0. `settings`: those that it will be played with; a state that was recorded under others is of no use to them,
// nor is a real device's to a simulated one. The run must have a tick.
struct HandStart {
  TickState<2> state;
  bool is_recorded;  // else at rest
};
HandStart start_of_hand(const Run& run, const Settings& settings);

}  // namespace ghostforce
