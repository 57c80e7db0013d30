// What a tick does for one strategy; core/tick.h does it for all of them. Inline, so that a loop over ticks can keep
// the state in registers. noexcept, allocates nothing, takes no lock, reads no clock. Any thread.
//
// The state is written axis by axis: a vector that is copied as one is read back in other pieces than it was written
// in, and for that the processor waits. For the same reason what includes this is compiled without gcc's pairing of
// scalars (-fno-tree-slp-vectorize). The numbers are the same either way, to the last bit.
#pragma once

#include "core/energy.h"
#include "core/proxy.h"
#include "core/tick.h"

namespace ghostforce {

template <glm::length_t D>
using StrategyPlan = typename TickPlan<D>::StrategyPlan;
template <glm::length_t D>
using StrategyState = typename TickState<D>::StrategyState;

// f_r of the state as it stands.
template <glm::length_t D>
Vector<D> force_of(const StrategyPlan<D>& plan, const StrategyState<D>& state) noexcept {
  return plan.rendering * (state.proxy - state.motion.position);
}

// The device has moved under the force held since the tick before, and the proxy belongs to `tracked`.
template <glm::length_t D>
void move(const TickPlan<D>& plan, const Vector<D>& proxy_step, const DeviceMotion<D>& motion, const Vector<D>& tracked,
          const Vector<D>& held_force, StrategyState<D>& state) noexcept {
  state.energy += work(held_force, motion.position - state.motion.position);
  for (glm::length_t i = 0; i < D; ++i) {
    state.motion.position[i] = motion.position[i];
    state.motion.velocity[i] = motion.velocity[i];
  }
  state.in_contact = place_proxy(tracked, plan.wall, proxy_step, state.proxy);
}

// (23) (24) with the force held from the tick before, then the proxy (25) of the device of the tick before.
template <glm::length_t D>
void tick_strategy(const TickPlan<D>& plan, const StrategyPlan<D>& own, const Vector<D>& goal,
                   StrategyState<D>& state) noexcept {
  const Vector<D> before = state.motion.position;
  const Vector<D> held_force = force_of<D>(own, state);
  move<D>(plan, own.proxy_step, step(plan.device, state.motion, goal, held_force), before, held_force, state);
}

}  // namespace ghostforce
