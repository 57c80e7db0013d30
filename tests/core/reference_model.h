// The model a second time, to compare with: dense matrices in extended precision, written straight from the balance of
// forces and the loop in docs/theory.md, and solved by Eigen. It shares no formula and no code with core/; only
// settings go in and numbers come out. Sizes are known at run time only, so that Eigen's solvers are compiled once.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/conventions.h"
#include "tests/core/random_setting.h"

namespace ghostforce {

// 64 bits of mantissa where the processor has them: the rounding of the reference is then 2000 times below that of
// double, and what a comparison shows is the rounding of core/.
using Extended = long double;

using ReferenceVector = Eigen::Matrix<Extended, Eigen::Dynamic, 1>;
using ReferenceMatrix = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;

template <glm::length_t D>
ReferenceVector reference(const Vector<D>& v) {
  ReferenceVector r(D);
  for (glm::length_t i = 0; i < D; ++i) r[i] = v[i];
  return r;
}

template <glm::length_t D>
ReferenceMatrix reference(const Matrix<D>& m) {
  ReferenceMatrix r(D, D);
  for (glm::length_t row = 0; row < D; ++row) {
    for (glm::length_t column = 0; column < D; ++column) r(row, column) = m[column][row];
  }
  return r;
}

// |a − b|
double distance(const ReferenceVector& a, const ReferenceVector& b);
// Greatest difference of an entry.
double distance(const ReferenceMatrix& a, const ReferenceMatrix& b);

template <glm::length_t D>
double distance(const Vector<D>& a, const ReferenceVector& b) {
  return distance(reference(a), b);
}
template <glm::length_t D>
double distance(const Matrix<D>& a, const ReferenceMatrix& b) {
  return distance(reference(a), b);
}

ReferenceMatrix reference_identity(glm::length_t dimension);

// P_A as A (AᵀA)⁻¹ Aᵀ, for any basis A, one direction a column.
ReferenceMatrix reference_projector_of(const ReferenceMatrix& basis);

template <glm::length_t D>
ReferenceMatrix reference_projector(const std::vector<Vector<D>>& basis) {
  ReferenceMatrix A(D, static_cast<Eigen::Index>(basis.size()));
  for (std::size_t i = 0; i < basis.size(); ++i) A.col(static_cast<Eigen::Index>(i)) = reference(basis[i]);
  return reference_projector_of(A);
}

struct ReferenceModel {
  ReferenceVector o;
  ReferenceVector n;
  ReferenceMatrix K_r;
  ReferenceMatrix K_t;
  Extended k_u;
  Extended k_c;
};

// K_r = k_r P_A, K_t = k_t P_A + (k_t/ρ) P_N
ReferenceModel reference_of(const ReferenceVector& o, const ReferenceVector& n, const ReferenceMatrix& P_A,
                            const Stiffnesses& k, Extended ratio);

template <glm::length_t D>
ReferenceModel underactuated_reference(const Setting<D>& setting, Extended ratio) {
  return reference_of(reference(setting.wall.point), reference(setting.wall.normal),
                      reference_projector<D>(setting.motors), setting.stiffnesses, ratio);
}

// K_r = k_r I, K_t = k_t I
template <glm::length_t D>
ReferenceModel fully_actuated_reference(const Setting<D>& setting) {
  return reference_of(reference(setting.wall.point), reference(setting.wall.normal), reference_identity(D),
                      setting.stiffnesses, 1.0L);
}

// --- At rest ---------------------------------------------------------------------------------------------------------

struct ReferenceEquilibrium {
  ReferenceVector proxy;
  ReferenceVector device;
  ReferenceVector force;
};

// Forces in balance on proxy and device, with q_p, q_h and the wall's push λ as unknowns:
//     (6)      K_t (q_h − q_p) + λ n = 0
//     (3)(4)   n·q_p + λ/k_c = n·o                     that is λ = k_c n·(o − q_p)
//     (7)      k_u (q_u − q_h) + K_r (q_p − q_h) = 0
// k_c = ∞ makes λ the multiplier of the hard constraint n·q_p = n·o.
ReferenceEquilibrium reference_equilibrium(const ReferenceModel& model, const ReferenceVector& goal);

// (22)(25)  The same for the proxy alone, the device being where it is. In contact, n·(q_h − o) < 0:
//     K_t (q_h − q_p) + λ n = 0
//     n·q_p + λ/k_c = n·o
// In free space q_p = q_h. λ is kept: without it the system would be
//     (K_t + k_c n nᵀ) q_p = K_t q_h + k_c n nᵀ o
// whose matrix is worse conditioned by k_c/k_t and does not exist for the hard wall.
ReferenceVector reference_proxy(const ReferenceModel& model, const ReferenceVector& device);

// --- In time ---------------------------------------------------------------------------------------------------------

struct ReferenceLoop {
  ReferenceModel model;
  Extended mass;
  Extended damping;
  Extended period;
};

struct ReferenceState {
  ReferenceVector device;
  ReferenceVector proxy;
  ReferenceVector velocity;
  ReferenceVector force;
  Extended energy = 0.0L;
};

// k = 0
ReferenceState reference_start(const ReferenceVector& goal);

// (23) (24) (25), then (5), and the work of the force held until now.
ReferenceState reference_tick(const ReferenceLoop& loop, const ReferenceState& before, const ReferenceVector& goal);

// The slowest of the loop's modes, free or in contact, as the factor by which it shrinks per tick. With
// x = (q_h,k−1, q_p,k−1, v_k−1) and everything that drives the loop at zero, (23) to (25) are one matrix; the proxy is
// q_h in free space and a linear map of it in contact. Below 1: stable.
double reference_slowest_mode(const ReferenceLoop& loop);

}  // namespace ghostforce
