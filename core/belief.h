// What a belief about the hand's stiffness costs, at rest, and what to believe where nothing is known. Pure, any thread;
// never allocates or throws. docs/theory.md, "What a wrong belief costs".
#pragma once

#include <cmath>

#include "core/settings.h"

namespace ghostforce {

// The error of anisotropic rendering over that of the naïve one, under the same goal, for ghost force and drift alike [1]:
//     R = (1 − 1/β) D₁ / (D₁ + κ (1 − α)/β),   D₁ = 1 + κα + ε
// 0: none; 1: no better than naïve. Below 0: the belief is too low, and the error has the other sign.
// `beta`: β = believed/true k_u; `alpha`: α = nᵀP_A n; `kappa`: κ = k_r/k_u; `epsilon`: ε = k_t/k_c.
inline double error_of_belief(double beta, double alpha, double kappa, double epsilon) noexcept {
  const double naive = 1.0 + kappa * alpha + epsilon;
  return (1.0 - 1.0 / beta) * naive / (naive + kappa * (1.0 - alpha) / beta);
}

// What a hand may have that nobody has measured [N/m].
inline constexpr NumberRange usual_hands{50.0, 1000.0};

// The tracking ratio ρ of least regret for a hand somewhere in `hands` [1]: the greater of the errors at its two ends,
// over the force of the fully actuated strategy, is as small as it can be. The positive root of
//     2(1 − α)ρ² + [(2α − 1)(a₁ + a₂) + 2ε]ρ − [2α a₁a₂ + ε(a₁ + a₂)] = 0,   a_i = 1 + k_r/k_i
inline double least_regret_ratio(double alpha, double k_r, double epsilon, const NumberRange& hands) noexcept {
  const double a_1 = optimal_tracking_ratio(k_r, hands.least);
  const double a_2 = optimal_tracking_ratio(k_r, hands.greatest);
  const double sum = a_1 + a_2;
  const double a = 2.0 * (1.0 - alpha);
  const double b = (2.0 * alpha - 1.0) * sum + 2.0 * epsilon;
  const double c = -(2.0 * alpha * a_1 * a_2 + epsilon * sum);
  // Of the two forms of the root the one that does not cancel, and that also holds for α = 1, where a is 0.
  const double root = std::sqrt(b * b - 4.0 * a * c);
  return b > 0.0 ? -2.0 * c / (b + root) : (root - b) / (2.0 * a);
}

// The belief with which anisotropic rendering has that ratio for these settings and usual_hands [N/m].
double least_regret_belief(const Settings& settings) noexcept;

}  // namespace ghostforce
