// Energy that the rendering gives to the hand. W > 0: the rendering was active, not passive. Pure, any thread.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>

#include "core/conventions.h"

namespace ghostforce {

// What one tick adds to W [J]; the force is held while the device moves:
//     W_k − W_{k−1} = f_r,k−1 · (q_h,k − q_h,k−1)
template <glm::length_t D>
double work(const Vector<D>& held_force, const Vector<D>& moved) noexcept {
  return glm::dot(held_force, moved);
}

// W over one slow closed loop of the *device* inside the wall, for a device in the plane with one motor [J]:
//     W = −k_r sinθ cosθ S / (cos²θ + ρ sin²θ + k_t/k_c)
// `theta` θ: from n to the actuated direction, counter-clockwise [rad]; `loop_area` S: counter-clockwise + [m²]. One
// sense of the loop makes energy, the other takes the same away. A fully actuated device: 0.
//
// A sampled loop adds what the delay does, to first order in dt:
//     − k_r dt ∫(A·v)² dt             the motors lose this, as the force is held for a tick
//     + 1.5 g dt ∫(A·v)(n·v) dt       the wall, 1.5 ticks late, adds this
//     with g = k_r cosθ / (cos²θ + ρ sin²θ + k_t/k_c)
// In free space only the loss is left.
inline double energy_per_loop(double k_r, double k_t, double k_c, double tracking_ratio, double theta,
                              double loop_area) noexcept {
  const double cosine = std::cos(theta);
  const double sine = std::sin(theta);
  return -k_r * sine * cosine * loop_area / (cosine * cosine + tracking_ratio * sine * sine + k_t / k_c);
}

}  // namespace ghostforce
