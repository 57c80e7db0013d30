// What a belief about the hand's stiffness costs at rest, what to believe where nothing is known, and how a belief
// follows the hand that is measured. Pure functions and a plain value; any thread; never allocates or throws.
// docs/theory.md, "What a wrong belief costs".
#pragma once

#include <cmath>

#include "core/hand_estimator.h"
#include "core/settings.h"

namespace ghostforce {

// The error of anisotropic rendering over that of naïve rendering, under the same goal, for ghost force and drift [1]:
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

// Lets the believed k_u follow the measured hand. It moves only where the hand is another than believed, and never
// faster than the loop can take: raising ρ is always safe, and falling is at these rates (docs/theory.md, "Letting ρ
// follow"). Where the hand is unknown it holds, and then glides to the belief of least regret.
class BeliefFollower {
 public:
  // How often it is asked [s].
  static constexpr double period_s = HandEstimator::period_s;
  // Of ln ρ [1/s].
  static constexpr double greatest_rise = 3.0;
  static constexpr double greatest_fall = 1.0;
  // Nearer than this to what is aimed at, the hand is the same: of |ln(k̂/k)| [1].
  static constexpr double hysteresis = 0.1;
  // How long an unknown hand is taken to be the one that was known last [s].
  static constexpr double holds_s = 3.0;

  // What is believed when it begins [N/m].
  explicit BeliefFollower(double believed_k_u) noexcept : believed_(believed_k_u), aim_(believed_k_u) {}

  // Once every period_s. Returns what to believe from now on [N/m]. `fallback`: the belief of least regret.
  double update(const HandEstimate& estimate, double k_r, double fallback) noexcept;

 private:
  double believed_;
  double aim_;
  double unknown_s_ = 0.0;
};

}  // namespace ghostforce
