#include "core/belief.h"

#include <glm/geometric.hpp>

namespace ghostforce {

double least_regret_belief(const Settings& settings) noexcept {
  const auto& [k_u, believed, k_r, k_t, k_c, ratio] = settings.stiffnesses;
  const Vector<2> normal = wall_of(settings).normal;
  const double alpha = glm::dot(normal, actuation_of(settings).actuated * normal);
  const double best = least_regret_ratio(alpha, k_r, k_t / k_c, usual_hands);
  // Without a rendered force every ratio is 1, and every belief is as good. The clamp is against rounding.
  return usual_hands.nearest_to(best > 1.0 ? k_r / (best - 1.0) : usual_hands.greatest);
}

}  // namespace ghostforce
