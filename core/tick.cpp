#include "core/tick.h"

#include <cstddef>

#include "core/ghost_force.h"

namespace ghostforce {

template <glm::length_t D>
TickCoefficients<D> coefficients_of(const Wall<D>& wall, const Actuation<D>& actuation, const Stiffnesses& stiffnesses,
                                    double mass, double damping, double rate) noexcept {
  TickCoefficients<D> coefficients{wall, actuation, sampled_device(mass, damping, stiffnesses.k_u, 1.0 / rate),
                                   rate, {},        0.0};
  for (const Strategy& strategy : strategy_catalog()) {
    const Coupling<D> coupling = make_coupling(strategy, stiffnesses, actuation);
    coefficients.strategies[index_of(strategy.id)] = {coupling.rendering,
                                                      proxy_gain(wall.normal, coupling, stiffnesses.k_c)};
  }
  return coefficients;
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

// All strategies but one, under the state's goal, with a renderer that sees the devices through an encoder. Apart, so
// that a tick without one costs no more.
template <glm::length_t D>
[[gnu::noinline]] void tick_through_encoder(const TickCoefficients<D>& coefficients, std::size_t but_for,
                                            TickState<D>& state) noexcept {
  const auto measure = [step = coefficients.encoder_step](const Vector<D>& device) {
    return measured_position(step, device);
  };
  for (std::size_t i = 0; i < strategy_count; ++i) {
    if (i == but_for) continue;
    tick_strategy<D>(coefficients, coefficients.strategies[i], state.goal, state.strategies[i], measure);
  }
}

}  // namespace

// Flattened: all of a strategy's vectors in registers, from its state and back into it.
template <glm::length_t D>
[[gnu::flatten]] void tick(const TickCoefficients<D>& coefficients, const Vector<D>& goal,
                           TickState<D>& state) noexcept {
  ++state.tick;
  state.goal = goal;
  state.measured.reset();
  if (coefficients.encoder_step != 0.0) [[unlikely]]
    return tick_through_encoder(coefficients, strategy_count, state);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    tick_strategy<D>(coefficients, coefficients.strategies[i], goal, state.strategies[i]);
  }
}

template <glm::length_t D>
[[gnu::flatten]] void tick_with_device(const TickCoefficients<D>& coefficients, StrategyId active,
                                       const Vector<D>& device, const Vector<D>& motor_force, double believed_k_u,
                                       TickState<D>& state, double goal_share) noexcept {
  const std::size_t measured = index_of(active);
  const StrategyCoefficients<D>& own_coefficients = coefficients.strategies[measured];
  StrategyState<D>& own = state.strategies[measured];
  // What was there before was simulated: from there to the real device is no way that anything has moved.
  if (state.measured != active) own.motion.position = device;
  ++state.tick;
  state.measured = active;
  const Vector<D> velocity = (device - own.motion.position) * coefficients.rate;
  move<D>(coefficients, own_coefficients.proxy_gain, {device, velocity}, device, force_of<D>(own_coefficients, own),
          own);
  const Vector<D> goal = device - motor_force / believed_k_u;
  state.goal = goal_share < 1.0 && own.in_contact ? glm::mix(state.goal, goal, goal_share) : goal;
  if (coefficients.encoder_step != 0.0) [[unlikely]]
    return tick_through_encoder(coefficients, measured, state);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    if (i != measured) tick_strategy<D>(coefficients, coefficients.strategies[i], state.goal, state.strategies[i]);
  }
}

template <glm::length_t D>
SnapshotIn<D> snapshot_of(const TickCoefficients<D>& coefficients, const TickState<D>& state) noexcept {
  SnapshotIn<D> snapshot;
  take_snapshot(coefficients, state, snapshot);
  return snapshot;
}

namespace {

// `forces`: f_r of each strategy [N].
template <glm::length_t D>
[[gnu::always_inline]] inline void write_snapshot(const TickCoefficients<D>& coefficients, const TickState<D>& state,
                                                  const PerStrategy<Vector<D>>& forces,
                                                  SnapshotIn<D>& snapshot) noexcept {
  snapshot.tick = state.tick;
  snapshot.time_s = time_of(state.tick, coefficients.rate);
  snapshot.goal = state.goal;
  snapshot.measured = state.measured;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const StrategyState<D>& own = state.strategies[i];
    const bool is_compared = own.in_contact && !state.measured;
    StrategySnapshot<D>& shown = snapshot.strategies[i];
    shown.device = own.motion.position;
    shown.proxy = own.proxy;
    shown.contact = projection(coefficients.wall, own.proxy);
    shown.force = forces[i];
    shown.ghost_force = is_compared ? ghost_force(coefficients.actuation, forces[i], forces[index_of(StrategyId::full)])
                                    : Vector<D>(0.0);
    shown.proxy_drift = is_compared ? proxy_drift(coefficients.wall, own.proxy, state.goal) : Vector<D>(0.0);
    shown.energy = own.energy;
    shown.in_contact = own.in_contact;
  }
}

// Apart, so that a snapshot without an encoder costs no more.
template <glm::length_t D>
[[gnu::noinline]] void take_snapshot_through_encoder(const TickCoefficients<D>& coefficients, const TickState<D>& state,
                                                     SnapshotIn<D>& snapshot) noexcept {
  PerStrategy<Vector<D>> forces;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const bool is_real = state.measured && index_of(*state.measured) == i;
    const StrategyState<D>& own = state.strategies[i];
    forces[i] = rendered_force<D>(coefficients.strategies[i], own.proxy,
                                  measured_position(is_real ? 0.0 : coefficients.encoder_step, own.motion.position));
  }
  write_snapshot(coefficients, state, forces, snapshot);
}

}  // namespace

template <glm::length_t D>
[[gnu::flatten]] void take_snapshot(const TickCoefficients<D>& coefficients, const TickState<D>& state,
                                    SnapshotIn<D>& snapshot) noexcept {
  if (coefficients.encoder_step != 0.0) [[unlikely]]
    return take_snapshot_through_encoder(coefficients, state, snapshot);
  PerStrategy<Vector<D>> forces;
  for (std::size_t i = 0; i < strategy_count; ++i)
    forces[i] = force_of<D>(coefficients.strategies[i], state.strategies[i]);
  write_snapshot(coefficients, state, forces, snapshot);
}

#define GHOSTFORCE_INSTANTIATE(D)                                                                                  \
  template TickCoefficients<D> coefficients_of<D>(const Wall<D>&, const Actuation<D>&, const Stiffnesses&, double, \
                                                  double, double) noexcept;                                        \
  template TickState<D> state_at_start<D>(const Vector<D>&) noexcept;                                              \
  template void tick<D>(const TickCoefficients<D>&, const Vector<D>&, TickState<D>&) noexcept;                     \
  template void tick_with_device<D>(const TickCoefficients<D>&, StrategyId, const Vector<D>&, const Vector<D>&,    \
                                    double, TickState<D>&, double) noexcept;                                       \
  template SnapshotIn<D> snapshot_of<D>(const TickCoefficients<D>&, const TickState<D>&) noexcept;                 \
  template void take_snapshot<D>(const TickCoefficients<D>&, const TickState<D>&, SnapshotIn<D>&) noexcept
GHOSTFORCE_INSTANTIATE(2);
GHOSTFORCE_INSTANTIATE(3);
GHOSTFORCE_INSTANTIATE(4);
#undef GHOSTFORCE_INSTANTIATE

}  // namespace ghostforce
