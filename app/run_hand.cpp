#include "app/run_hand.h"

#include <algorithm>

#include "core/play.h"

namespace ghostforce {

TickState<2> recorded_state(const RunTick& tick, const RunState& state) {
  TickState<2> whole;
  whole.tick = tick.tick;
  whole.goal = tick.goal;
  whole.measured = tick.measured;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    if (!tick.rows[i]) continue;
    const RunRow& row = *tick.rows[i];
    whole.strategies[i] = {{row.device, state.velocity[i]}, row.proxy, state.energy[i], row.proxy != row.device};
  }
  return whole;
}

HandStart start_of_hand(const Run& run, const Settings& settings) {
  const RunTick& first = run.ticks.front();
  const bool has_same_settings = run.scene && first.is_sure && run.settings[first.settings] == settings;
  if (has_same_settings && !first.measured) {
    const bool is_whole = std::ranges::all_of(first.rows, [](const auto& row) { return row.has_value(); });
    if (first.state != RunTick::none && is_whole) {
      TickState<2> state = recorded_state(first, run.states[first.state]);
      state.tick = 0;
      return {state, true};
    }
    // As `simulate` begins: devices and proxies where the hand is.
    if (first.state == RunTick::none && first.tick == 0) return {state_at_start(first.goal), true};
  }
  return {state_at_rest(settings, first.goal), false};
}

}  // namespace ghostforce
