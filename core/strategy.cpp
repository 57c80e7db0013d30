#include "core/strategy.h"

namespace ghostforce {
namespace {

double isotropic(const Stiffnesses&) noexcept {
  return 1.0;
}

constexpr std::string_view full_sentence =
    "A motor for every direction: the wall feels as it should. The reference for the other two.";

constexpr PerStrategy<Strategy> catalog = std::to_array<Strategy>({
    {StrategyId::full, "full", 'F', "Fully actuated", full_sentence, full_sentence, full_sentence, true, isotropic},
    {StrategyId::naive, "naive", 'N', "Naïve",
     "One motor, rendered as if there were two: a ghost force drags the hand along the wall.",
     "One motor, rendered as if there were two: a ghost force drags the hand along the wall.",
     "One motor, rendered as if there were two. Here that makes no ghost force: the motor pushes straight out of the "
     "wall.",
     false, isotropic},
    {StrategyId::anisotropic, "anisotropic", 'A', "Anisotropic",
     "One motor, and a proxy that follows softly in the direction without a motor. At the optimal ratio ρ* the ghost "
     "force is gone.",
     "One motor, and a proxy that follows softly in the direction without a motor. But ρ is not the ratio that this "
     "hand needs: a ghost force remains.",
     "One motor, and a proxy that follows softly in the direction without a motor. The ghost force is gone.", false,
     tracking_ratio},
});

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
