#include "app/replay.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "app/failure.h"
#include "app/run_hand.h"

namespace ghostforce {
namespace {

class Replay {
 public:
  explicit Replay(const Run& run) : run_(run) {}

  // False: the state at this tick cannot be known.
  bool go_to(const RunTick& tick) {
    const Settings& settings = run_.settings[tick.settings];
    if (!has_plan_ || &settings != settings_) use(settings);
    if (tick.state != RunTick::none) {
      resume(tick, run_.states[tick.state]);
    } else if (is_first_ && tick.tick == 0) {
      state_ = state_at_start(tick.goal);
      is_known_.fill(true);
    } else if (!is_any_known() || tick.tick != state_.tick + 1) {
      is_known_.fill(false);
    } else {
      follow(tick);
    }
    is_first_ = false;
    if (!tick.is_sure) is_known_.fill(false);
    return is_any_known();
  }

  const Settings& settings() const noexcept { return *settings_; }
  Snapshot snapshot() const noexcept { return snapshot_of(plan_, state_); }
  const PerStrategy<bool>& is_known() const noexcept { return is_known_; }
  bool compares(const RunTick& tick, StrategyId id) const noexcept {
    return is_known_[index_of(id)] && tick.rows[index_of(id)] && tick.measured != id;
  }

 private:
  void use(const Settings& settings) {
    // As the servo goes on at another rate: model time does.
    if (has_plan_ && plan_.rate != settings.rate) {
      state_.tick = std::llround(time_of(state_.tick, plan_.rate) * settings.rate);
    }
    settings_ = &settings;
    plan_ = plan_of(settings);
    has_plan_ = true;
  }

  void resume(const RunTick& tick, const RunState& recorded) {
    state_ = recorded_state(tick, recorded);
    for (std::size_t i = 0; i < strategy_count; ++i) is_known_[i] = tick.rows[i].has_value();
  }

  void follow(const RunTick& now) {
    const TickState<2> before = state_;
    tick(plan_, now.goal, state_);
    if (!now.measured) return;
    // A real device is where it was measured, and its proxy belongs to that place.
    const std::size_t i = index_of(*now.measured);
    state_.measured = now.measured;
    if (!now.rows[i]) {
      is_known_[i] = false;
      return;
    }
    auto& measured = state_.strategies[i];
    measured.motion.position = now.rows[i]->device;
    measured.motion.velocity = (now.rows[i]->device - before.strategies[i].motion.position) * plan_.rate;
    measured.proxy = now.rows[i]->proxy;
    measured.in_contact = measured.proxy != measured.motion.position;
  }

  bool is_any_known() const noexcept {
    return std::ranges::any_of(is_known_, [](bool is_known) { return is_known; });
  }

  const Run& run_;
  const Settings* settings_ = nullptr;
  TickPlan<2> plan_{};
  bool has_plan_ = false;
  TickState<2> state_;
  PerStrategy<bool> is_known_{};
  bool is_first_ = true;
};

bool is_same(double a, double b) noexcept {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// Compares one row of the file with the replay's, value by value.
bool compare(const RunTick& tick, const Snapshot& snapshot, StrategyId id, ReplayReport& report) {
  const RunRow& row = *tick.rows[index_of(id)];
  const StrategySnapshot<2>& now = snapshot.strategies[index_of(id)];
  struct Value {
    std::string_view column;
    double recorded;
    double replayed;
    bool is_force;
  };
  const std::array values{
      Value{"t_s", tick.time_s, snapshot.time_s, false},      Value{"device_x_m", row.device.x, now.device.x, false},
      Value{"device_y_m", row.device.y, now.device.y, false}, Value{"proxy_x_m", row.proxy.x, now.proxy.x, false},
      Value{"proxy_y_m", row.proxy.y, now.proxy.y, false},    Value{"force_x_N", row.force.x, now.force.x, true},
      Value{"force_y_N", row.force.y, now.force.y, true},
  };
  bool all_same = true;
  for (const Value& value : values) {
    if (is_same(value.recorded, value.replayed)) continue;
    all_same = false;
    if (!report.first) report.first = {tick.time_s, id, value.column, value.recorded, value.replayed};
    if (value.column == "t_s") continue;
    double& greatest = value.is_force ? report.greatest_N : report.greatest_m;
    greatest = std::max(greatest, std::abs(value.recorded - value.replayed));
  }
  return all_same;
}

}  // namespace

ReplayReport replay(const Run& run, const std::function<void(const ReplayedTick&)>& on_tick) {
  if (!run.scene || run.ticks.empty()) {
    throw Failure(ExitCode::wrong_call, run.scene ? "the run holds no row: there is nothing to replay"
                                                  : "the run does not tell its scene: it cannot be replayed");
  }
  ReplayReport report;
  Replay replay(run);
  for (const RunTick& tick : run.ticks) {
    if (!replay.go_to(tick)) {
      ++report.skipped;
      continue;
    }
    const RunState* const state = tick.state == RunTick::none ? nullptr : &run.states[tick.state];
    if (state != nullptr) ++report.resumed;
    const Snapshot snapshot = replay.snapshot();
    ++report.compared;
    if (tick.measured) ++report.measured;
    bool is_same_tick = true;
    for (const Strategy& each : strategy_catalog()) {
      if (replay.compares(tick, each.id)) is_same_tick &= compare(tick, snapshot, each.id, report);
    }
    if (!is_same_tick) ++report.diverging;
    on_tick({snapshot, replay.settings(), state, replay.is_known()});
  }
  return report;
}

}  // namespace ghostforce
