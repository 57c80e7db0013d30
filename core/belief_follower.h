// BeliefFollower: lets the believed k_u follow the measured hand. It moves only where the hand is another than believed,
// and never faster than the loop can take: raising ρ is always safe, and falling is at these rates (docs/theory.md,
// "Letting ρ follow"). Where the hand is unknown it holds, and then glides to the belief of least regret. A plain value;
// never allocates or throws; any one thread.
#pragma once

#include "core/hand_estimator.h"

namespace ghostforce {

class BeliefFollower {
 public:
  // It is asked this often [s].
  static constexpr double period_s = HandEstimator::period_s;
  // Of ln ρ [1/s].
  static constexpr double greatest_rise = 3.0;
  static constexpr double greatest_fall = 1.0;
  // Nearer than this to what is aimed at, the hand is the same: of |ln(k̂/k)| [1].
  static constexpr double hysteresis = 0.1;
  // For so long an unknown hand is taken to be the one that was known last [s].
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
