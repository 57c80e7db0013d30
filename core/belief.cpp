#include "core/belief.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/stiffness.h"

namespace ghostforce {

double least_regret_belief(const Settings& settings) noexcept {
  const auto& [k_u, believed, k_r, k_t, k_c, ratio] = settings.stiffnesses;
  const Vector<2> normal = wall_of(settings).normal;
  const double alpha = glm::dot(normal, actuation_of(settings).actuated * normal);
  const double best = least_regret_ratio(alpha, k_r, k_t / k_c, usual_hands);
  // Without a rendered force every ratio is 1, and every belief is as good. The clamp is against rounding.
  return usual_hands.nearest_to(best > 1.0 ? k_r / (best - 1.0) : usual_hands.greatest);
}

double BeliefFollower::update(const HandEstimate& estimate, double k_r, double fallback) noexcept {
  if (estimate.is_known()) {
    unknown_s_ = 0.0;
    if (std::abs(std::log(estimate.k_u / aim_)) > hysteresis) aim_ = estimate.k_u;
  } else {
    unknown_s_ += period_s;
    // Half a period, because the sum of tenths is not exact.
    aim_ = unknown_s_ > holds_s + 0.5 * period_s ? fallback : believed_;
  }
  const double ratio = optimal_tracking_ratio(k_r, believed_);
  const double wanted = std::log(optimal_tracking_ratio(k_r, aim_) / ratio);
  const double step = std::clamp(wanted, -greatest_fall * period_s, greatest_rise * period_s);
  // The last step ends exactly there, so that afterwards nothing changes any more.
  believed_ = step == wanted ? aim_ : k_r / (ratio * std::exp(step) - 1.0);
  return believed_;
}

}  // namespace ghostforce
