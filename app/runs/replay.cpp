#include "app/runs/replay.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "app/base/failure.h"
#include "app/files/program_build.h"
#include "core/divergence.h"
#include "core/simulate.h"

namespace ghostforce {
namespace {

bool is_same(double a, double b) noexcept {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

double Divergence::difference() const noexcept {
  const double difference = std::abs(recorded - replayed);
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

double Deviation::relative() const noexcept {
  const double difference = greatest ? greatest->difference() : 0.0;
  return difference == 0.0 ? 0.0 : difference / magnitude;  // without a magnitude: infinite
}

const Deviation& ReplayReport::worst() const {
  return *std::ranges::max_element(deviations, {}, &Deviation::relative);
}

Agreement agreement(const RunFacts& run, const ReplayReport& report) {
  if (report.compared == 0) return Agreement::unknown;
  if (!report.first) return Agreement::identical;
  const bool is_close = report.worst().relative() <= replay_tolerance;
  return is_close && run.version != program_build() ? Agreement::close : Agreement::diverging;
}

ReplayReport replay(const Run& run, const std::function<void(const ReplayedTick&)>& on_tick) {
  Replay replay(on_tick);
  for (const RunTick& tick : run.ticks) replay.take(run, tick);
  return replay.report();
}

void Replay::take(const RunFacts& run, const RunTick& tick) {
  const RunState* const state = tick.state == RunTick::none ? nullptr : &run.states[tick.state];
  if (!go_to(tick, run.settings[tick.settings], run.scene->stiffness_path, state)) {
    ++report_.skipped;
    return;
  }
  if (state != nullptr) ++report_.resumed;
  const Snapshot snapshot = snapshot_of(coefficients_, state_);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    if (!is_known_[i] || tick.rows[i] || !has_diverged(snapshot.strategies[i])) continue;
    is_known_[i] = false;
    if (!report_.ran_away_s[i]) report_.ran_away_s[i] = snapshot.time_s;
  }
  ++report_.compared;
  if (tick.measured) ++report_.measured;
  bool is_same_tick = true;
  for (const Strategy& each : strategy_catalog()) {
    const std::size_t i = index_of(each.id);
    const bool compares = is_known_[i] && tick.rows[i] && tick.measured != each.id;
    if (compares) is_same_tick &= compare_row(tick, snapshot, each.id);
  }
  if (!is_same_tick) ++report_.diverging;
  if (!on_tick_) return;
  PerStrategy<Vector<2>> tones;
  std::ranges::transform(state_.strategies, tones.begin(), &TickState<2>::StrategyState::tone);
  on_tick_({snapshot, *settings_, state, is_known_, tones, contact_readings_of(state_)});
}

// False: the state at this tick cannot be known.
bool Replay::go_to(const RunTick& tick, const Settings& settings, const StiffnessPath& stiffness,
                   const RunState* state) {
  if (settings_ != settings) use(settings);
  if (state != nullptr) {
    state_ = recorded_state(tick, *state);
    std::ranges::transform(tick.rows, is_known_.begin(), [](const auto& row) { return row.has_value(); });
  } else if (is_first_ && tick.tick == 0) {
    state_ = state_at_start(settings, tick.goal);
    is_known_.fill(true);
  } else if (!is_any_known() || tick.tick != state_.tick + 1) {
    is_known_.fill(false);
  } else {
    if (!stiffness.is_empty()) {
      set_user_stiffness(coefficients_, stiffness_at(stiffness, time_of(tick.tick, coefficients_.rate())));
    }
    follow(tick);
  }
  is_first_ = false;
  return is_any_known();
}

void Replay::use(const Settings& settings) {
  // As the servo goes on at another rate: model time does.
  if (settings_ && coefficients_.rate() != settings.rate) {
    state_.tick = std::llround(time_of(state_.tick, coefficients_.rate()) * settings.rate);
  }
  settings_ = settings;
  coefficients_ = loop_coefficients_of(settings);
}

void Replay::follow(const RunTick& now) {
  const TickState<2> before = state_;
  tick(coefficients_, now.goal, state_);
  for (std::size_t i = 0; i < strategy_count; ++i) state_.strategies[i].tone = tone_on_simulated(now, i);
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
  measured.motion.velocity = (now.rows[i]->device - before.strategies[i].motion.position) * coefficients_.rate();
  measured.proxy = now.rows[i]->proxy;
  measured.in_contact = measured.proxy != measured.motion.position;
}

bool Replay::is_any_known() const noexcept {
  return std::ranges::any_of(is_known_, std::identity{});
}

// Compares one row of the file with the replay's, value by value.
bool Replay::compare_row(const RunTick& tick, const Snapshot& snapshot, StrategyId id) {
  const RunRow& row = *tick.rows[index_of(id)];
  const StrategySnapshot<2>& now = snapshot.strategies[index_of(id)];
  using enum ReplayedQuantity;
  struct Value {
    std::string_view column;
    double recorded;
    double replayed;
    ReplayedQuantity quantity;
  };
  const std::array values{
      Value{"t_s", tick.time_s, snapshot.time_s, time},        Value{"device_x_m", row.device.x, now.device.x, device},
      Value{"device_y_m", row.device.y, now.device.y, device}, Value{"proxy_x_m", row.proxy.x, now.proxy.x, proxy},
      Value{"proxy_y_m", row.proxy.y, now.proxy.y, proxy},     Value{"force_x_N", row.force.x, now.force.x, force},
      Value{"force_y_N", row.force.y, now.force.y, force},
  };
  bool all_same = true;
  for (const Value& value : values) {
    Deviation& deviation = report_.deviations[static_cast<std::size_t>(value.quantity)];
    if (std::isfinite(value.replayed)) deviation.magnitude = std::max(deviation.magnitude, std::abs(value.replayed));
    if (is_same(value.recorded, value.replayed)) continue;
    all_same = false;
    const Divergence divergence{tick.time_s, id, value.column, value.recorded, value.replayed};
    if (!report_.first) report_.first = divergence;
    if (!deviation.greatest || divergence.difference() > deviation.greatest->difference()) {
      deviation.greatest = divergence;
    }
  }
  return all_same;
}

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
                           .tone = tone_on_simulated(tick, i),
                           .force = row.force,
                           .contact = {.efforts = row.efforts}};
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
