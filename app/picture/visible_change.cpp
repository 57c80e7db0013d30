#include "app/picture/visible_change.h"

#include <glm/geometric.hpp>

namespace ghostforce {

bool differs_visibly(const Snapshot& seen, const Snapshot& now, const LeastVisible& least) noexcept {
  if (now.measured != seen.measured || glm::distance(now.goal, seen.goal) > least.step) return true;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    const StrategySnapshot<2>& a = seen.strategies[i];
    const StrategySnapshot<2>& b = now.strategies[i];
    if (a.in_contact != b.in_contact || glm::distance(a.device, b.device) > least.step ||
        glm::distance(a.proxy, b.proxy) > least.step || glm::distance(a.force, b.force) > least.force ||
        glm::distance(a.ghost_force, b.ghost_force) > least.force) {
      return true;
    }
  }
  return false;
}

}  // namespace ghostforce
