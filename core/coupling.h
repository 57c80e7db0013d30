// Coupling: the two stiffness matrices that a strategy puts between device and proxy. Pure values, any thread.
#pragma once

#include "core/actuation.h"
#include "core/conventions.h"

namespace ghostforce {

template <glm::length_t D>
struct Coupling {
  Matrix<D> rendering;            // K_r, (5) [N/m]
  Matrix<D> tracking;             // K_t, (2) [N/m]
  Matrix<D> tracking_compliance;  // K_t⁻¹ [m/N]; known in closed form, so nothing is ever inverted
};

// Every degree of freedom has a motor (section 4.1):
//     K_r = k_r I
//     K_t = k_t I
template <glm::length_t D>
Coupling<D> fully_actuated_coupling(double k_r, double k_t) noexcept {
  return {Matrix<D>(k_r), Matrix<D>(k_t), Matrix<D>(1.0 / k_t)};
}

// Motors on the actuated degrees of freedom only:
//     K_r = k_r P_A
//     K_t = k_t P_A + (k_t/ρ) P_N     (16)
// ρ = 1 is naïve rendering (section 4.2), ρ = ρ* of (17) the cure (section 5).
template <glm::length_t D>
Coupling<D> underactuated_coupling(double k_r, double k_t, double tracking_ratio,
                                   const Actuation<D>& actuation) noexcept {
  return {k_r * actuation.actuated, k_t * actuation.actuated + (k_t / tracking_ratio) * actuation.unactuated,
          (1.0 / k_t) * actuation.actuated + (tracking_ratio / k_t) * actuation.unactuated};
}

}  // namespace ghostforce
