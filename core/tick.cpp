#include "core/tick.h"

#include <cstddef>

#include "core/energy.h"
#include "core/ghost_force.h"
#include "core/proxy.h"

namespace ghostforce {

template <glm::length_t D>
TickPlan<D> plan_tick(const Wall<D>& wall, const Actuation<D>& actuation, const Impedances& impedances, double mass,
                      double damping, double rate) noexcept {
  TickPlan<D> plan{wall, actuation, {mass, damping, impedances.k_u, 1.0 / rate}, rate, {}};
  for (const Strategy& strategy : strategy_catalog()) {
    const Coupling<D> coupling = make_coupling(strategy, impedances, actuation);
    plan.strategies[index_of(strategy.id)] = {coupling.rendering, proxy_step(wall.normal, coupling, impedances.k_c)};
  }
  return plan;
}

template <glm::length_t D>
TickState<D> state_at_start(const Vector<D>& goal) noexcept {
  TickState<D> state;
  state.goal = goal;
  for (auto& strategy : state.strategies) {
    strategy.motion.position = goal;
    strategy.proxy = goal;
  }
  return state;
}

namespace {

// f_r of the state as it stands.
template <glm::length_t D>
Vector<D> force_of(const TickPlan<D>& plan, const TickState<D>& state, std::size_t i) noexcept {
  return plan.strategies[i].rendering * (state.strategies[i].proxy - state.strategies[i].motion.position);
}

// The device has moved under the force held since the tick before, and the proxy belongs to `tracked`.
template <glm::length_t D>
void move(const TickPlan<D>& plan, std::size_t i, const DeviceMotion<D>& motion, const Vector<D>& tracked,
          const Vector<D>& held_force, TickState<D>& state) noexcept {
  auto& strategy = state.strategies[i];
  strategy.energy += work(held_force, motion.position - strategy.motion.position);
  strategy.motion = motion;
  const Proxy<D> proxy = proxy_of(tracked, plan.wall, plan.strategies[i].proxy_step);
  strategy.proxy = proxy.position;
  strategy.in_contact = proxy.in_contact;
}

template <glm::length_t D>
void simulate(const TickPlan<D>& plan, std::size_t i, TickState<D>& state) noexcept {
  const DeviceMotion<D> before = state.strategies[i].motion;
  const Vector<D> held_force = force_of(plan, state, i);
  move(plan, i, step(plan.device, before, state.goal, held_force), before.position, held_force, state);
}

}  // namespace

template <glm::length_t D>
void tick(const TickPlan<D>& plan, const Vector<D>& goal, TickState<D>& state) noexcept {
  ++state.tick;
  state.goal = goal;
  state.measured.reset();
  for (std::size_t i = 0; i < strategy_count; ++i) simulate(plan, i, state);
}

template <glm::length_t D>
void tick_measured(const TickPlan<D>& plan, StrategyId active, const Vector<D>& device, const Vector<D>& felt,
                   double believed_k_u, TickState<D>& state) noexcept {
  ++state.tick;
  state.measured = active;
  const std::size_t measured = index_of(active);
  const Vector<D> velocity = (device - state.strategies[measured].motion.position) * plan.rate;
  move(plan, measured, {device, velocity}, device, force_of(plan, state, measured), state);
  state.goal = device - felt / believed_k_u;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    if (i != measured) simulate(plan, i, state);
  }
}

template <glm::length_t D>
SnapshotIn<D> snapshot_of(const TickPlan<D>& plan, const TickState<D>& state) noexcept {
  SnapshotIn<D> snapshot;
  snapshot.tick = state.tick;
  snapshot.time_s = time_of(state.tick, plan.rate);
  snapshot.goal = state.goal;
  snapshot.measured = state.measured;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const auto& strategy = state.strategies[i];
    auto& out = snapshot.strategies[i];
    out.device = strategy.motion.position;
    out.proxy = strategy.proxy;
    out.contact = projection(plan.wall, strategy.proxy);
    out.force = force_of(plan, state, i);
    out.energy = strategy.energy;
    out.in_contact = strategy.in_contact;
  }
  const Vector<D> full_force = snapshot.strategies[index_of(StrategyId::full)].force;
  for (auto& out : snapshot.strategies) {
    if (!out.in_contact || state.measured) continue;
    out.ghost_force = ghost_force(plan.actuation, out.force, full_force);
    out.proxy_drift = proxy_drift(plan.wall, out.proxy, state.goal);
  }
  return snapshot;
}

#define GHOSTFORCE_INSTANTIATE(D)                                                                            \
  template TickPlan<D> plan_tick<D>(const Wall<D>&, const Actuation<D>&, const Impedances&, double, double,  \
                                    double) noexcept;                                                        \
  template TickState<D> state_at_start<D>(const Vector<D>&) noexcept;                                        \
  template void tick<D>(const TickPlan<D>&, const Vector<D>&, TickState<D>&) noexcept;                       \
  template void tick_measured<D>(const TickPlan<D>&, StrategyId, const Vector<D>&, const Vector<D>&, double, \
                                 TickState<D>&) noexcept;                                                    \
  template SnapshotIn<D> snapshot_of<D>(const TickPlan<D>&, const TickState<D>&) noexcept
GHOSTFORCE_INSTANTIATE(2);
GHOSTFORCE_INSTANTIATE(3);
GHOSTFORCE_INSTANTIATE(4);
#undef GHOSTFORCE_INSTANTIATE

}  // namespace ghostforce
