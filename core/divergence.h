// Divergence: settings can make the sampled loop unstable, and its numbers then grow without end. One rule for the servo,
// the commands and the pictures says from when on they mean nothing. noexcept, allocates nothing; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/snapshot.h"
#include "core/strategy.h"
#include "core/tick.h"

namespace ghostforce {

// No device is farther away than this [m]; a scene lies within a metre.
inline constexpr double farthest_device_m = 10.0;

// No run is longer: a year and a half at the highest rate, far from where the number of a tick would overflow.
inline constexpr std::int64_t last_tick_ever = 1'000'000'000'000;

// A place in a scene or not far from one; false for NaN.
inline bool is_near(const Vector<2>& place) noexcept {
  return std::abs(place.x) <= farthest_device_m && std::abs(place.y) <= farthest_device_m;
}

inline bool is_finite(const Vector<2>& vector) noexcept {
  return std::isfinite(vector.x) && std::isfinite(vector.y);
}

// Whether the simulation cannot continue from this state: some number in it is not finite, or too large.
inline bool has_diverged(const TickState<2>& state) noexcept {
  return !(state.tick >= 0 && state.tick <= last_tick_ever && is_near(state.goal) &&
           std::ranges::all_of(state.strategies, [](const TickState<2>::StrategyState& strategy) {
             return is_near(strategy.motion.position) && is_near(strategy.proxy) &&
                    is_finite(strategy.motion.velocity) && std::isfinite(strategy.energy);
           }));
}

// Whether the device of one strategy has run away.
inline bool has_diverged(const StrategySnapshot<2>& strategy) noexcept {
  return !(is_near(strategy.device) && is_near(strategy.proxy) && is_finite(strategy.force) &&
           std::isfinite(strategy.energy));
}

// The first strategy, in the catalog's order, whose device has run away; empty: none.
inline std::optional<StrategyId> diverged_strategy(const Snapshot& snapshot) noexcept {
  for (const Strategy& each : strategy_catalog()) {
    if (has_diverged(snapshot.strategies[index_of(each.id)])) return each.id;
  }
  return std::nullopt;
}

}  // namespace ghostforce
