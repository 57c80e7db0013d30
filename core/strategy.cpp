#include "core/strategy.h"

namespace ghostforce {
namespace {

double isotropic(const Impedances&) noexcept {
  return 1.0;
}

constexpr PerStrategy<Strategy> catalog{{
    {StrategyId::full, "full", 'F', "Fully actuated",
     "A motor on every axis: the wall as it should feel. The reference for the "
     "other two.",
     true, isotropic},
    {StrategyId::naive, "naive", 'N', "Naïve",
     "One motor, rendered as if there were two: a ghost force drags the hand "
     "along the wall.",
     false, isotropic},
    {StrategyId::anisotropic, "anisotropic", 'A', "Anisotropic",
     "The same single motor, with a proxy that follows more softly where there "
     "is none: the ghost force is gone.",
     false, tracking_ratio},
}};

}  // namespace

const PerStrategy<Strategy>& strategy_catalog() noexcept {
  return catalog;
}

std::optional<StrategyId> find_strategy(std::string_view name) noexcept {
  for (const Strategy& entry : catalog) {
    if (entry.name == name) return entry.id;
  }
  return std::nullopt;
}

}  // namespace ghostforce
