// Divergence: whether the simulation has run away, so that it cannot continue from its state. Settings can make the
// sampled loop unstable; its numbers then grow without end. Pure, never allocates or throws, any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/tick.h"

namespace ghostforce {

// No device is farther away than this [m]; a scene lies within a metre.
inline constexpr double farthest_device_m = 1000.0;

// Some number in it is not finite, or too large to continue from.
inline bool has_diverged(const TickState<2>& state) noexcept {
  // A year and a half at the highest rate; far from where a tick number would overflow.
  constexpr std::int64_t last_tick_ever = 1'000'000'000'000;
  const auto is_near = [](const Vector<2>& v) {  // false for NaN
    return std::abs(v.x) <= farthest_device_m && std::abs(v.y) <= farthest_device_m;
  };
  return !(state.tick >= 0 && state.tick <= last_tick_ever && is_near(state.goal) &&
           std::ranges::all_of(state.strategies, [&](const TickState<2>::StrategyState& strategy) {
             return is_near(strategy.motion.position) && is_near(strategy.proxy) &&
                    std::isfinite(strategy.motion.velocity.x) && std::isfinite(strategy.motion.velocity.y) &&
                    std::isfinite(strategy.energy);
           }));
}

}  // namespace ghostforce
