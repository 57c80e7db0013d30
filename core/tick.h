// One tick of the sampled-data loop, for all strategies under the same goal.
// noexcept, allocates nothing, takes no lock, reads no clock: settings, state and reading come in as values, a snapshot
// goes out. Any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/actuation.h"
#include "core/contact_status.h"
#include "core/energy.h"
#include "core/proxy.h"
#include "core/sampled_device.h"
#include "core/snapshot.h"
#include "core/stiffness.h"
#include "core/strategy.h"
#include "core/wall.h"

namespace ghostforce {

// What a tick needs of the settings, computed once per change of a setting.
template <glm::length_t D>
struct TickCoefficients {
  struct StrategyCoefficients {
    Matrix<D> rendering;   // K_r [N/m]
    Vector<D> proxy_gain;  // see proxy.h [1]
  };
  Wall<D> wall;
  Actuation<D> actuation;
  SampledDevice device;
  double rate;  // 1/dt [Hz]
  PerStrategy<StrategyCoefficients> strategies;
  double encoder_step = 0.0;  // what the renderer sees of a simulated device (sampled_device.h) [m]; 0: where it is
};

// From the next tick on the hand has another stiffness [N/m]. The renderer knows nothing of it.
template <glm::length_t D>
void set_user_stiffness(TickCoefficients<D>& coefficients, double k_u) noexcept {
  const SampledDevice& device = coefficients.device;
  coefficients.device = sampled_device(device.mass, device.damping, k_u, device.period);
}

// t_k = k dt [s], rounded once: k/rate is the nearest number to it, k·(1/rate) is not always.
inline double time_of(std::int64_t tick, double rate) noexcept {
  return static_cast<double>(tick) / rate;
}

// `mass` [kg], `damping` [N·s/m], `rate` [Hz].
template <glm::length_t D>
TickCoefficients<D> coefficients_of(const Wall<D>& wall, const Actuation<D>& actuation, const Stiffnesses& stiffnesses,
                                    double mass, double damping, double rate) noexcept;

// What is carried from tick to tick. Trivially copyable.
template <glm::length_t D>
struct TickState {
  struct StrategyState {
    DeviceMotion<D> motion{Vector<D>(0.0), Vector<D>(0.0)};  // q_h [m], v [m/s]
    Vector<D> proxy{0.0};                                    // q_p [m]
    double energy = 0.0;                                     // W [J]
    bool in_contact = false;
    Vector<D> tone{0.0};  // beside f_r, from this tick to the next [N]

    // Of general scenes alone (general_tick.h): what the motors do from this tick to the next.
    Vector<D> force{0.0};  // f_r [N]
    ContactReading contact{};
  };
  std::int64_t tick = 0;               // k
  Vector<D> goal{0.0};                 // q_u [m]
  std::optional<StrategyId> measured;  // see SnapshotIn
  PerStrategy<StrategyState> strategies{};
};

// k = 0:  q_h = q_p = q_u(0), v = 0, f_r = 0.
template <glm::length_t D>
TickState<D> state_at_start(const Vector<D>& goal) noexcept;

// k ≥ 1, in this order, per strategy: (23) (24) with force and tone held from tick k − 1; then the proxy (25) of the
// device of tick k − 1 (the delay of sampled data). Advances `state` from k − 1 to k; `goal` is q_u(t_k). The tones of
// tick k, which measure the hand (measuring_tones.h), are for the caller to set: those before stay.
template <glm::length_t D>
void tick(const TickCoefficients<D>& coefficients, const Vector<D>& goal, TickState<D>& state) noexcept;

// k ≥ 1 with a real device under `active`: nothing of it is simulated. q_h is measured and the proxy is that of the
// same tick's q_h, so that free space is exactly force-free; the goal is inferred from the device's equilibrium (7),
//     q_u ≈ q_h − f / k̂_u
// with the force `motor_force` that the motors really make, f_r after the limits on its way to them; 0 in free space.
// The other strategies are simulated under that goal. `believed_k_u` is k̂_u [N/m]. Work is counted and the velocity is
// known from the second tick in a row that measures the device under `active`; after a gap in the measurements, reset
// state.measured. `goal_share`: in contact, of the way to the inferred goal that the goal goes in this tick; below 1 it
// is low-passed, as while tones shake the device.
template <glm::length_t D>
void tick_with_device(const TickCoefficients<D>& coefficients, StrategyId active, const Vector<D>& device,
                      const Vector<D>& motor_force, double believed_k_u, TickState<D>& state,
                      double goal_share = 1.0) noexcept;

// The state as it stands: rendered force, ghost force and proxy drift.
//     f_r,k = K_r (q_p,k − q_h,k)
// where a simulated q_h counts as its encoder shows it.
template <glm::length_t D>
SnapshotIn<D> snapshot_of(const TickCoefficients<D>& coefficients, const TickState<D>& state) noexcept;

// snapshot_of(), written to where it is wanted.
template <glm::length_t D>
void take_snapshot(const TickCoefficients<D>& coefficients, const TickState<D>& state,
                   SnapshotIn<D>& snapshot) noexcept;

// --- One strategy ----------------------------------------------------------------------------------------------------

// Inline, so that a loop over ticks can keep the state in registers.
//
// The state is written axis by axis: a vector that is copied as a whole is read back in other pieces than it was
// written in, and the processor waits for that. For the same reason, the code that calls these is compiled without
// gcc's pairing of scalars (-fno-tree-slp-vectorize). The numbers are the same either way, to the last bit.

template <glm::length_t D>
using StrategyCoefficients = typename TickCoefficients<D>::StrategyCoefficients;
template <glm::length_t D>
using StrategyState = typename TickState<D>::StrategyState;

// (5)  f_r = K_r (q_p − q_h)
template <glm::length_t D>
Vector<D> rendered_force(const StrategyCoefficients<D>& coefficients, const Vector<D>& proxy,
                         const Vector<D>& device) noexcept {
  return coefficients.rendering * (proxy - device);
}

// Of the state as it stands, with a renderer that sees the device itself.
template <glm::length_t D>
Vector<D> force_of(const StrategyCoefficients<D>& coefficients, const StrategyState<D>& state) noexcept {
  return rendered_force<D>(coefficients, state.proxy, state.motion.position);
}

// The device has moved under the force held since the tick before, and the proxy belongs to `tracked`. The energy is
// the rendering's alone: a tone is none of it.
template <glm::length_t D>
void move(const TickCoefficients<D>& coefficients, const Vector<D>& proxy_gain, const DeviceMotion<D>& motion,
          const Vector<D>& tracked, const Vector<D>& held_force, StrategyState<D>& state) noexcept {
  state.energy += work(held_force, motion.position - state.motion.position);
  for (glm::length_t i = 0; i < D; ++i) {
    state.motion.position[i] = motion.position[i];
    state.motion.velocity[i] = motion.velocity[i];
  }
  state.in_contact = place_proxy(tracked, coefficients.wall, proxy_gain, state.proxy);
}

// A renderer that sees the device itself.
struct ExactMeasurement {
  template <typename Position>
  const Position& operator()(const Position& device) const noexcept {
    return device;
  }
};

// (23) (24) with force and tone held from the tick before, then the proxy (25) of the device of the tick before.
// `measure`: what the renderer sees of a device.
template <glm::length_t D, typename Measure = ExactMeasurement>
void tick_strategy(const TickCoefficients<D>& coefficients, const StrategyCoefficients<D>& own, const Vector<D>& goal,
                   StrategyState<D>& state, const Measure& measure = {}) noexcept {
  const Vector<D> before = measure(state.motion.position);
  const Vector<D> held_force = rendered_force<D>(own, state.proxy, before);
  move<D>(coefficients, own.proxy_gain, step(coefficients.device, state.motion, goal, held_force + state.tone), before,
          held_force, state);
}

}  // namespace ghostforce
