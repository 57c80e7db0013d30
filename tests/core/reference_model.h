// The model a second time, to compare with: dense matrices in extended precision, written straight from the balance of
// forces and the loop in docs/theory.md, and solved by Eigen. It shares no formula and no code with core/; only
// settings go in and numbers come out.
#pragma once

#include <vector>

#include <Eigen/Dense>

#include "core/conventions.h"
#include "tests/core/random_setting.h"

namespace ghostforce {

// 64 bits of mantissa where the processor has them: the rounding of the reference is then 2000 times below that of
// double, and what a comparison shows is the rounding of core/.
using Extended = long double;

template <glm::length_t D>
using ReferenceVector = Eigen::Matrix<Extended, D, 1>;

template <glm::length_t D>
using ReferenceMatrix = Eigen::Matrix<Extended, D, D>;

template <glm::length_t D>
ReferenceVector<D> reference(const Vector<D>& v) {
  ReferenceVector<D> r;
  for (glm::length_t i = 0; i < D; ++i) r[i] = v[i];
  return r;
}

template <glm::length_t D>
ReferenceMatrix<D> reference(const Matrix<D>& m) {
  ReferenceMatrix<D> r;
  for (glm::length_t row = 0; row < D; ++row) {
    for (glm::length_t column = 0; column < D; ++column) r(row, column) = m[column][row];
  }
  return r;
}

// |a − b|
template <glm::length_t D>
double distance(const Vector<D>& a, const ReferenceVector<D>& b) {
  return static_cast<double>((reference(a) - b).norm());
}

// P_A as A (AᵀA)⁻¹ Aᵀ, for any basis A.
template <glm::length_t D>
ReferenceMatrix<D> reference_projector(const std::vector<Vector<D>>& basis) {
  Eigen::Matrix<Extended, D, Eigen::Dynamic> A(D, static_cast<Eigen::Index>(basis.size()));
  for (std::size_t i = 0; i < basis.size(); ++i) A.col(static_cast<Eigen::Index>(i)) = reference(basis[i]);
  const Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic> gram = A.transpose() * A;
  return A * gram.fullPivLu().solve(A.transpose().eval());
}

template <glm::length_t D>
struct ReferenceModel {
  ReferenceVector<D> o;
  ReferenceVector<D> n;
  ReferenceMatrix<D> K_r;
  ReferenceMatrix<D> K_t;
  Extended k_u;
  Extended k_c;
};

// K_r = k_r I, K_t = k_t I
template <glm::length_t D>
ReferenceModel<D> reference_with_every_motor(const Setting<D>& setting) {
  const ReferenceMatrix<D> I = ReferenceMatrix<D>::Identity();
  return {reference(setting.wall.point), reference(setting.wall.normal), setting.impedances.k_r * I,
          setting.impedances.k_t * I,    setting.impedances.k_u,         setting.impedances.k_c};
}

// K_r = k_r P_A, K_t = k_t P_A + (k_t/ρ) P_N
template <glm::length_t D>
ReferenceModel<D> reference_with_some_motors(const Setting<D>& setting, Extended ratio) {
  const ReferenceMatrix<D> P_A = reference_projector<D>(setting.motors);
  const ReferenceMatrix<D> P_N = ReferenceMatrix<D>::Identity() - P_A;
  return {reference(setting.wall.point), reference(setting.wall.normal),
          setting.impedances.k_r * P_A,  setting.impedances.k_t * P_A + setting.impedances.k_t / ratio * P_N,
          setting.impedances.k_u,        setting.impedances.k_c};
}

template <glm::length_t D>
struct ReferenceRest {
  ReferenceVector<D> proxy;
  ReferenceVector<D> device;
  ReferenceVector<D> force;
};

// Forces in balance on proxy and device, with q_p, q_h and the wall's push λ as unknowns:
//   (6)   K_t (q_h − q_p) + λ n = 0,  where by (3)(4)  λ = k_c n·(o − q_p), written  n·q_p + λ/k_c = n·o
//   (7)   k_u (q_u − q_h) + K_r (q_p − q_h) = 0
// k_c = ∞ makes λ the multiplier of the hard constraint n·q_p = n·o.
template <glm::length_t D>
ReferenceRest<D> reference_rest(const ReferenceModel<D>& model, const ReferenceVector<D>& goal) {
  constexpr Eigen::Index unknowns = 2 * D + 1;
  using System = Eigen::Matrix<Extended, unknowns, unknowns>;
  using Unknowns = Eigen::Matrix<Extended, unknowns, 1>;
  System lhs = System::Zero();
  Unknowns rhs = Unknowns::Zero();
  lhs.template block<D, D>(0, 0) = -model.K_t;
  lhs.template block<D, D>(0, D) = model.K_t;
  lhs.template block<D, 1>(0, 2 * D) = model.n;
  lhs.template block<D, D>(D, 0) = model.K_r;
  lhs.template block<D, D>(D, D) = -model.K_r - model.k_u * ReferenceMatrix<D>::Identity();
  rhs.template segment<D>(D) = -model.k_u * goal;
  lhs.template block<1, D>(2 * D, 0) = model.n.transpose();
  lhs(2 * D, 2 * D) = 1.0L / model.k_c;
  rhs[2 * D] = model.n.dot(model.o);
  const Unknowns x = lhs.fullPivLu().solve(rhs);
  const ReferenceVector<D> proxy = x.template segment<D>(0);
  const ReferenceVector<D> device = x.template segment<D>(D);
  return {proxy, device, model.K_r * (proxy - device)};
}

// (22)(25)  The same for the proxy alone, the device being where it is: K_t (q_h − q_p) + λ n = 0 and n·q_p + λ/k_c =
// n·o where n·(q_h − o) < 0, else q_p = q_h. Eliminating λ gives the paper's (K_t + k_c n nᵀ) q_p = K_t q_h + k_c n nᵀ
// o, whose matrix is worse conditioned by k_c/k_t and does not exist for the hard wall.
template <glm::length_t D>
ReferenceVector<D> reference_proxy(const ReferenceModel<D>& model, const ReferenceVector<D>& device) {
  if (!(model.n.dot(device - model.o) < 0.0L)) return device;
  using System = Eigen::Matrix<Extended, D + 1, D + 1>;
  using Unknowns = Eigen::Matrix<Extended, D + 1, 1>;
  System lhs;
  Unknowns rhs;
  lhs << -model.K_t, model.n, model.n.transpose(), 1.0L / model.k_c;
  rhs << -(model.K_t * device), model.n.dot(model.o);
  const Unknowns x = lhs.fullPivLu().solve(rhs);
  return x.template head<D>();
}

}  // namespace ghostforce
