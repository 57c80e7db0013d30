// Simulates a scene's scripted hand from its first tick to a given one, as fast as the machine can: what `simulate`
// writes, `render` draws and the window starts from. The same tick as the servo's. Any thread.
#pragma once

#include <cstdint>
#include <type_traits>

#include "core/general_equilibrium.h"
#include "core/general_tick.h"
#include "core/scene.h"

namespace ghostforce {

// Those of a general scene in contact. A strategy without a rest begins as in free space.
inline void use_general_equilibria(const Settings& settings, const Vector<2>& goal, TickState<2>& state) noexcept {
  const GeneralScene scene = general_scene_of(settings);
  for (const Strategy& each : strategy_catalog()) {
    const std::optional<GeneralEquilibrium> rest = general_equilibrium_of(each.id, scene, goal);
    if (!rest || !rest->at.in_contact) continue;
    auto& strategy = state.strategies[index_of(each.id)];
    strategy.motion.position = rest->at.device;
    strategy.proxy = rest->at.proxy;
    strategy.in_contact = true;
    strategy.force = rest->at.force;
    strategy.contact = {rest->efforts, rest->active, ContactStatus::contact};
  }
}

// Where all strategies come to rest under a goal that is held still, as a state to continue from: k = 0, v = 0, W = 0.
// In free space it is state_at_start().
inline TickState<2> equilibrium_state(const Settings& settings, const Vector<2>& goal) noexcept {
  TickState<2> state = state_at_start(settings, goal);
  if (is_general(settings)) {
    use_general_equilibria(settings, goal, state);
    return state;
  }
  for (const Strategy& each : strategy_catalog()) {
    const Equilibrium<2> rest = equilibrium_of(each.id, settings, goal);
    if (!rest.in_contact) continue;
    auto& strategy = state.strategies[index_of(each.id)];
    strategy.motion.position = rest.device;
    strategy.proxy = rest.proxy;
    strategy.in_contact = true;
  }
  return state;
}

// The same for a scene's hand as it is when a run begins.
inline TickState<2> equilibrium_at_start(const Scene& scene, const Vector<2>& goal) noexcept {
  return equilibrium_state(settings_at(scene, scene.settings, 0.0), goal);
}

// Calls on_tick(const Snapshot&), or on_tick(const Snapshot&, const TickState<2>&), for k = 0 … last, beginning with `state`, whose k is 0, and returns the state after
// the last tick, from which a servo may continue.
template <typename OnTick>
TickState<2> simulate_from(TickState<2> state, const Scene& scene, std::int64_t last, OnTick&& on_tick) {
  LoopCoefficients coefficients = loop_coefficients_of(scene.settings);
  const TremorAndDriftMotion tremor_and_drift(scene.tremor_and_drift);
  const bool changes_stiffness = !scene.stiffness_path.is_empty();
  const auto tell = [&] {
    if constexpr (std::is_invocable_v<OnTick&, const Snapshot&, const TickState<2>&>) {
      on_tick(snapshot_of(coefficients, state), state);
    } else {
      on_tick(snapshot_of(coefficients, state));
    }
  };
  tell();
  while (state.tick < last) {
    const double time_s = time_of(state.tick + 1, coefficients.rate());
    if (changes_stiffness) set_user_stiffness(coefficients, stiffness_at(scene.stiffness_path, time_s));
    tick(coefficients, tremor_and_drift.shaken(goal_at(scene.goal, time_s), time_s), state);
    tell();
  }
  return state;
}

// The same from where a scene's hand begins: with the devices there too, wherever the wall is.
template <typename OnTick>
TickState<2> simulate(const Scene& scene, std::int64_t last, OnTick&& on_tick) {
  return simulate_from(state_at_start(scene.settings, goal_at(scene.goal, 0.0)), scene, last, on_tick);
}

}  // namespace ghostforce
