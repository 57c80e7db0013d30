// The compliances that a general scene is rendered with, and the projector on what its motors can make. Pure values and
// functions, never allocate or throw, any thread.
//
// τ = k_t/k_r. All is written with 1/τ, so that a k_r of 0, where nothing is rendered, is no special case.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/actuation_matrix.h"
#include "core/conventions.h"

namespace ghostforce {

template <glm::length_t D>
struct Compliances {
  Matrix<D> user;      // C_u of the hand that the renderer believes in [m/N]
  Matrix<D> tracking;  // C_r/τ: that of a device with every motor between device and proxy [m/N]
  double force_share;  // 1/τ: rendered force per contact force, likewise [1]
  double constraint;   // 1/k_c [m/N]; 0: hard
};

// Motors by their number: bit i for motor i.
using MotorSet = unsigned;

constexpr MotorSet all_motors(std::size_t count) noexcept {
  return (1U << count) - 1U;
}

// Π = A (AᵀC_uA)⁻¹ AᵀC_u for the columns of some motors: of all forces that they can make, it takes the one that leaves
// the hand nearest to where the given force would leave it, in the energy of the hand.
template <glm::length_t D>
struct ActuatedProjection {
  Matrix<D> projector{0.0};                    // Π; not symmetric unless the hand is isotropic
  std::array<Vector<D>, most_motors> efforts;  // rows of (AᵀC_uA)⁻¹ AᵀC_u; 0 for motors that are not in the set
  std::size_t rank = 0;                        // of the columns
};

// By Gram and Schmidt in the metric C_u, the longest column first, which is the pivoted Cholesky factorisation of
// AᵀC_uA. Columns that add nothing new are passed over: their motors get no effort.
template <glm::length_t D>
ActuatedProjection<D> actuated_projection(const ActuationMatrix<D>& actuation, MotorSet motors,
                                          const Matrix<D>& user_compliance) noexcept {
  ActuatedProjection<D> result;
  for (std::size_t i = 0; i < actuation.count; ++i) result.efforts[i] = Vector<D>(0.0);
  if (motors != 0 && (motors & (motors - 1U)) == 0) {  // one motor: the usual device
    std::size_t i = 0;
    while ((motors >> i) != 1U) ++i;
    const Vector<D>& a = actuation.columns[i];
    const Vector<D> moved = user_compliance * a;
    const double square = glm::dot(a, moved);
    if (!(square > 0.0)) return result;
    result.efforts[i] = moved / square;
    result.projector = glm::outerProduct(a, result.efforts[i]);
    result.rank = 1;
    return result;
  }
  // A column shorter than this share of itself after projection is a repetition [1], squared.
  constexpr double repetition = 1e-20;
  std::array<Vector<D>, most_motors> rest = actuation.columns;
  std::array<Efforts, most_motors> made_of{};  // each rest, of the columns
  Efforts whole{};                             // the columns' squared lengths
  MotorSet left = motors;
  for (std::size_t i = 0; i < actuation.count; ++i) {
    if ((motors >> i & 1U) == 0) continue;
    made_of[i][i] = 1.0;
    whole[i] = glm::dot(rest[i], user_compliance * rest[i]);
  }
  while (left != 0 && result.rank < static_cast<std::size_t>(D)) {
    std::size_t longest = most_motors;
    double square = 0.0;
    for (std::size_t i = 0; i < actuation.count; ++i) {
      if ((left >> i & 1U) == 0) continue;
      const double own = glm::dot(rest[i], user_compliance * rest[i]);
      if (own > repetition * whole[i] && own > square) {
        longest = i;
        square = own;
      }
    }
    if (longest == most_motors) break;
    left &= ~(1U << longest);
    ++result.rank;
    const double length = std::sqrt(square);
    const Vector<D> axis = rest[longest] / length;
    const Vector<D> moved = user_compliance * axis;
    result.projector += glm::outerProduct(axis, moved);
    Efforts axis_of = made_of[longest];
    for (double& share : axis_of) share /= length;
    for (std::size_t i = 0; i < actuation.count; ++i) {
      result.efforts[i] += axis_of[i] * moved;
      if ((left >> i & 1U) == 0) continue;
      const double along = glm::dot(moved, rest[i]);
      rest[i] -= along * axis;
      for (std::size_t k = 0; k < most_motors; ++k) made_of[i][k] -= along * axis_of[k];
    }
  }
  return result;
}

// C_t = [C_r + s C_u (I − Π)]/τ [m/N]: between device and proxy. s: the compliance share, 0 naïve, 1 the cure.
template <glm::length_t D>
Matrix<D> tracking_compliance(const Compliances<D>& compliances, const Matrix<D>& projector, double share) noexcept {
  if (share == 0.0) return compliances.tracking;
  return compliances.tracking + (share * compliances.force_share) * (compliances.user * (Matrix<D>(1.0) - projector));
}

}  // namespace ghostforce
