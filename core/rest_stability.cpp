#include "core/rest_stability.h"

#include <algorithm>

#include <glm/matrix.hpp>

namespace ghostforce {

bool leads_back(const GeneralScene& scene, const GeneralStrategy& strategy, const Vector<2>& handle,
                const Vector<2>& proxy) noexcept {
  const Contact<2> contact = contact_at(scene, strategy, handle, proxy);
  if (contact.status != ContactStatus::contact) return false;
  // Of differences [m]; not out of the wall, however shallow the handle is.
  const double step = std::min(1e-7, -0.01 * signed_distance(scene.constraint, handle));
  Matrix<2> stiffness = glm::inverse(scene.user_compliance);
  for (glm::length_t k = 0; k < 2; ++k) {
    Vector<2> beside = handle;
    beside[k] += step;
    const Contact<2> moved = contact_at(scene, strategy, beside, proxy);
    if (moved.status != ContactStatus::contact) return false;
    stiffness[k] -= (moved.force - contact.force) / step;
  }
  return stiffness[0][0] + stiffness[1][1] > 0.0 && glm::determinant(stiffness) > 0.0;
}

}  // namespace ghostforce
