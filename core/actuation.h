// Which degrees of freedom a device can push, and the two stiffness matrices that a strategy puts between device and
// proxy. Pure values, any thread.
#pragma once

#include <span>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/conventions.h"

namespace ghostforce {

// The split of the world into actuated and non-actuated subspaces. Only the two projectors are needed, never the bases
// A and N themselves.
template <glm::length_t D>
struct Actuation {
  Matrix<D> actuated;    // P_A = A Aᵀ [1]
  Matrix<D> unactuated;  // P_N = I − P_A [1]
};

// The actuated subspace is the span of `directions` (any lengths, need not be orthogonal). Directions that add nothing
// new (dependent or zero) are passed over, so the rank is that of the span.
template <glm::length_t D>
Actuation<D> actuated_along(std::span<const Vector<D>> directions) noexcept {
  // A direction shorter than this share of its own length after projection is a repetition, not a new direction.
  constexpr double repetition = 1e-12;
  Matrix<D> actuated(0.0);
  for (const Vector<D>& direction : directions) {
    // Subtracting twice keeps the projector orthogonal to rounding even for nearly parallel directions.
    Vector<D> fresh = direction - actuated * direction;
    fresh -= actuated * fresh;
    if (const double length = glm::length(fresh); length > repetition * glm::length(direction)) {
      fresh /= length;
      actuated += glm::outerProduct(fresh, fresh);
    }
  }
  return {actuated, Matrix<D>(1.0) - actuated};
}

// A device with one motor, as the window draws it.
template <glm::length_t D>
Actuation<D> actuated_along(const Vector<D>& direction) noexcept {
  return actuated_along<D>(std::span<const Vector<D>>(&direction, 1));
}

// How stiffly a strategy ties the proxy to the device (tracking) and the device to the proxy (rendering).
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
