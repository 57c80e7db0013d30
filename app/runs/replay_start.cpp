#include "app/runs/replay_start.h"

#include <algorithm>

#include "app/base/failure.h"
#include "core/simulate.h"

namespace ghostforce {

void HandPath::take(const RunFacts& run, const RunTick& tick) {
  if (is_over_) return;
  const double time_s = time_of_tick(run, tick);
  is_over_ = !path_.times.empty() && !(time_s > path_.times.back());
  if (is_over_) return;
  if (time_s * rate_ > most_ticks) throw too_long(run, tick);
  path_.points.push_back(tick.goal);
  path_.times.push_back(time_s);
}

// From whole ticks, as the servo reckons them: the goal of a tick is then that of its row, bit for bit.
double HandPath::time_of_tick(const RunFacts& run, const RunTick& tick) {
  if (!run.scene) {  // and so no rate
    if (path_.times.empty()) first_s_ = tick.time_s;
    return tick.time_s - first_s_;
  }
  const double rate = run.settings[tick.settings].rate;
  if (rate != stretch_rate_) {
    begin_ = tick.tick;
    begin_s_ = path_.times.empty() ? 0.0 : path_.times.back() + 1.0 / rate;
    stretch_rate_ = rate;
  }
  return begin_s_ + time_of(tick.tick - begin_, rate);
}

GoalPath goal_path_of(const Run& run, double rate) {
  if (run.ticks.empty()) throw Failure(ExitCode::wrong_call, "the run has no rows, so there is no hand to replay");
  HandPath path(rate);
  for (const RunTick& tick : run.ticks) path.take(run, tick);
  return path.take_path();
}

Vector<2> tone_on_simulated(const RunTick& tick, std::size_t strategy) noexcept {
  const std::optional<RunRow>& row = tick.rows[strategy];
  return row && !tick.measured ? row->tone : Vector<2>(0.0);
}

TickState<2> recorded_state(const RunTick& tick, const RunState& state) {
  TickState<2> whole;
  whole.tick = tick.tick;
  whole.goal = tick.goal;
  whole.measured = tick.measured;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    if (!tick.rows[i]) continue;
    const RunRow& row = *tick.rows[i];
    whole.strategies[i] = {.motion = {row.device, state.velocity[i]},
                           .proxy = row.proxy,
                           .energy = state.energy[i],
                           .in_contact = row.proxy != row.device,
                           .tone = tone_on_simulated(tick, i)};
  }
  return whole;
}

Scene scene_since(const RunFacts& run, const RunTick& first) {
  Scene scene = *run.scene;
  scene.stiffness_path = path_since(scene.stiffness_path, first.time_s);
  return scene;
}

ReplayStart replay_start(const RunFacts& run, const RunTick& first, const Scene& scene) {
  const bool has_same_settings = run.scene && run.settings[first.settings] == scene.settings;
  if (has_same_settings && !first.measured) {
    const bool is_whole = std::ranges::all_of(first.rows, [](const auto& row) { return row.has_value(); });
    if (first.state != RunTick::none && is_whole) {
      TickState<2> state = recorded_state(first, run.states[first.state]);
      state.tick = 0;
      return {state, true};
    }
    // As `simulate` begins: devices and proxies where the hand is.
    if (first.state == RunTick::none && first.tick == 0) return {state_at_start(scene.settings, first.goal), true};
  }
  return {equilibrium_at_start(scene, first.goal), false};
}

}  // namespace ghostforce
