#include "app/picture/quantities.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "core/units.h"

namespace ghostforce {
namespace {

constexpr std::array<Quantity, quantity_count> quantities{{
    {"force", "N", "force_N", Term::force, [](const StrategySnapshot<2>& now) { return glm::length(now.force); }, 2},
    {"ghost force", "N", "ghost_force_N", Term::ghost_force,
     [](const StrategySnapshot<2>& now) { return glm::length(now.ghost_force); }, 2, true},
    {"drift", "mm", "proxy_drift_mm", Term::proxy_drift,
     [](const StrategySnapshot<2>& now) { return glm::length(now.proxy_drift) * mm_per_m; }, 1, true},
    {"energy", "mJ", "energy_mJ", Term::energy, [](const StrategySnapshot<2>& now) { return now.energy * 1000.0; }, 1},
}};

}  // namespace

bool is_known(const Quantity& quantity, const Snapshot& snapshot, StrategyId id) noexcept {
  if (!quantity.is_against_goal || !snapshot.measured) return true;
  return snapshot.has_target && snapshot.measured == id &&
         !std::isnan(quantity.value(snapshot.strategies[index_of(id)]));
}

const std::array<Quantity, quantity_count>& quantity_catalog() noexcept {
  return quantities;
}

}  // namespace ghostforce
