// The device in the hand, sampled: one implicit Euler step of mass, damping and the user's spring, with the rendered
// force held from the tick before; and what the renderer's encoder tells of the device. Pure, never allocates or
// throws, any thread.
#pragma once

#include <cmath>

#include "core/conventions.h"

namespace ghostforce {

struct SampledDevice {
  double mass;                // m, device and hand together [kg]
  double damping;             // b, device and hand together [N·s/m]
  double user_stiffness;      // k_u [N/m]
  double period;              // dt [s]
  double velocity_kept;       // m / (m + dt b + dt² k_u), of one tick to the next [1]
  double velocity_per_force;  // dt / (m + dt b + dt² k_u) [m/s/N]
};

// Computes what the other four determine, once per change of a setting: a division takes longer than all the rest of a
// tick.
constexpr SampledDevice sampled_device(double mass, double damping, double user_stiffness, double period) noexcept {
  const double effective_mass = mass + period * damping + period * period * user_stiffness;
  return {mass, damping, user_stiffness, period, mass / effective_mass, period / effective_mass};
}

template <glm::length_t D>
struct DeviceMotion {
  Vector<D> position;  // q_h [m]
  Vector<D> velocity;  // v [m/s]
};

// (23)  (m + dt b + dt² k_u) v_k = m v_{k−1} + dt (k_u (q_u(t_k) − q_h,k−1) + K_r (q_p,k−1 − q_h,k−1))
// (24)  q_h,k = q_h,k−1 + dt v_k
// `held_force` is K_r (q_p,k−1 − q_h,k−1) [N]: what the rendering put on the hand until now.
template <glm::length_t D>
DeviceMotion<D> step(const SampledDevice& device, const DeviceMotion<D>& before, const Vector<D>& goal,
                     const Vector<D>& held_force) noexcept {
  const Vector<D> hand_force = device.user_stiffness * (goal - before.position);  // (1)
  const Vector<D> velocity =
      device.velocity_kept * before.velocity + device.velocity_per_force * (hand_force + held_force);
  return {before.position + device.period * velocity, velocity};
}

// What a renderer knows of where the device is, because an encoder counts steps: on each axis the nearest whole number
// of them [m]. `step` [m]; 0: the device itself, to the last bit.
template <glm::length_t D>
Vector<D> measured_position(double step, const Vector<D>& device) noexcept {
  if (step == 0.0) return device;
  Vector<D> measured;
  for (glm::length_t i = 0; i < D; ++i) measured[i] = step * std::nearbyint(device[i] / step);
  return measured;
}

}  // namespace ghostforce
