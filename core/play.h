// Plays a scene's scripted hand from its first tick to a given one, as fast as
// the machine can: what `simulate` writes, `render` draws and the window starts
// from. The same tick as the servo's. Any thread.
#pragma once

#include <cstdint>

#include "core/scene.h"

namespace ghostforce {

// Calls on_tick(const Snapshot&) for k = 0 … last and returns the state after
// the last tick, from which a servo may go on.
template <typename OnTick>
TickState<2> play(const Scene& scene, std::int64_t last, OnTick&& on_tick) {
  const TickPlan<2> plan = plan_of(scene.settings);
  TickState<2> state = state_at_start(goal_at(scene.goal, 0.0));
  on_tick(snapshot_of(plan, state));
  while (state.tick < last) {
    tick(plan, goal_at(scene.goal, time_of(state.tick + 1, plan.rate)), state);
    on_tick(snapshot_of(plan, state));
  }
  return state;
}

}  // namespace ghostforce
