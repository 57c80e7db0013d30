#include "app/tools/figures/simulated_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/interruption.h"
#include "app/base/typed_text.h"
#include "app/runs/replay.h"
#include "core/divergence.h"
#include "core/simulate.h"

namespace ghostforce {
namespace {

constexpr std::int64_t ticks_between_moments = 5;  // 200 Hz of a loop at 1 kHz: 16 points of the fastest tremor
constexpr std::int64_t most_moments = 6000;        // more are finer than any picture

struct Thinned {
  explicit Thinned(std::int64_t last_of_all)
      : last(last_of_all), between(std::max(ticks_between_moments, last / most_moments)) {}
  bool keeps(std::int64_t tick) const { return tick % between == 0 || tick == last; }

  std::int64_t last;
  std::int64_t between;
};

// What a recording says of each change.
std::vector<std::string> change_lines(const SimulatedMotion& motion) {
  Settings known = motion.scene.settings;
  fmt::memory_buffer text;
  for (const SettingsChange& change : motion.changes) append_set_lines(text, change.time_s, known, change.settings);
  std::vector<std::string> lines;
  constexpr std::string_view comment = "# ";
  for (std::string_view rest(text.data(), text.size()); !rest.empty();) {
    lines.emplace_back(take_until(rest, '\n').substr(comment.size()));
  }
  return lines;
}

Settings settings_at_end(const SimulatedMotion& motion) {
  return settings_at(motion.scene, last_settings(motion), motion.moments.back().time_s);
}

// `vectors` in the order of the columns.
std::vector<CsvCell> row_of(const SimulatedMotion& motion, StrategyId id, std::string source, double time_s,
                            std::initializer_list<Vector<2>> vectors) {
  std::vector<CsvCell> row{motion.name, std::string(strategy(id).name), std::move(source), time_s};
  for (const Vector<2>& vector : vectors) row.insert(row.end(), {vector.x, vector.y});
  return row;
}

}  // namespace

SimulatedMotion simulate_motion(std::string name, const Scene& scene) {
  SimulatedMotion motion{.name = std::move(name), .scene = scene};
  const Thinned thinned(last_tick(scene));
  simulate(scene, thinned.last, [&](const Snapshot& snapshot) {
    if (const auto id = diverged_strategy(snapshot)) throw unstable_loop(*id, snapshot.time_s);
    if (thinned.keeps(snapshot.tick)) motion.moments.push_back(snapshot);
    if (snapshot.tick % ticks_between_looks == 0) stop_if_interrupted();
  });
  motion.rest = predicted_equilibria(settings_at_end(motion), motion.moments.back().goal);
  return motion;
}

SimulatedMotion simulate_hand(const RecordedHand& hand) {
  SimulatedMotion motion{.name = "", .scene = hand.scene, .changes = hand.changes};
  const GoalPath& path = hand.scene.goal;
  const StiffnessPath& stiffness = hand.scene.stiffness_path;
  const Thinned thinned(last_tick(hand.scene));
  TickCoefficients<2> coefficients = coefficients_of(hand.scene.settings);
  TickState<2> state = hand.start;
  motion.moments.push_back(snapshot_of(coefficients, state));
  auto change = hand.changes.begin();
  for (std::size_t i = 1; i < path.times.size(); ++i) {
    for (; change != hand.changes.end() && change->time_s <= path.times[i]; ++change)
      coefficients = coefficients_of(change->settings);
    const double before_s = path.times[i - 1];
    // More than one where samples were lost.
    const auto ticks = std::max<std::int64_t>(1, std::llround((path.times[i] - before_s) * coefficients.rate));
    for (std::int64_t k = 1; k <= ticks; ++k) {
      const double time_s = k == ticks ? path.times[i] : before_s + time_of(k, coefficients.rate);
      if (!stiffness.is_empty()) set_user_stiffness(coefficients, stiffness_at(stiffness, time_s));
      tick(coefficients, goal_at(path, time_s), state);
      const Snapshot snapshot = snapshot_of(coefficients, state);
      if (const auto id = diverged_strategy(snapshot)) throw unstable_loop(*id, time_s, hand.name);
      if (state.tick % ticks_between_looks == 0) stop_if_interrupted();
      const bool is_last = k == ticks && i + 1 == path.times.size();
      if (!is_last && !thinned.keeps(state.tick)) continue;
      motion.moments.push_back(snapshot);
      motion.moments.back().time_s = time_s;  // the rate may have been another one before
    }
  }
  motion.rest = predicted_equilibria(settings_at_end(motion), motion.moments.back().goal);
  return motion;
}

const Settings& settings_at(const SimulatedMotion& motion, double time_s) {
  const auto next = std::ranges::upper_bound(motion.changes, time_s, {}, &SettingsChange::time_s);
  return next == motion.changes.begin() ? motion.scene.settings : std::prev(next)->settings;
}

const Settings& last_settings(const SimulatedMotion& motion) {
  return motion.changes.empty() ? motion.scene.settings : motion.changes.back().settings;
}

CsvTable table_of(std::span<const SimulatedMotion> motions) {
  CsvTable table;
  table.comments = {
      "One row per pane, strategy and moment of the simulation, and one for the closed form at rest (t_s nan).",
      "Units: s, m, N. The force is that of the device on the hand."};
  table.columns = {
      "pane",       "strategy",  "source",    "t_s",       "goal_x_m",  "goal_y_m",        "device_x_m",
      "device_y_m", "proxy_x_m", "proxy_y_m", "force_x_N", "force_y_N", "ghost_force_x_N", "ghost_force_y_N"};
  for (const SimulatedMotion& motion : motions) {
    std::ranges::move(change_lines(motion), std::back_inserter(table.comments));
    for (const Strategy& strategy : strategy_catalog()) {
      const std::size_t i = index_of(strategy.id);
      for (const Snapshot& moment : motion.moments) {
        const StrategySnapshot<2>& now = moment.strategies[i];
        table.rows.push_back(row_of(motion, strategy.id, "simulated", moment.time_s,
                                    {moment.goal, now.device, now.proxy, now.force, now.ghost_force}));
      }
      const auto& [rest, ghost_force, drift] = motion.rest[i];
      table.rows.push_back(row_of(motion, strategy.id, "closed form", std::numeric_limits<double>::quiet_NaN(),
                                  {rest.goal, rest.device, rest.proxy, rest.force, ghost_force}));
    }
  }
  return table;
}

RecordedHand recorded_hand(const Run& run, std::string name) {
  if (!run.scene) {
    throw Failure(
        ExitCode::wrong_call,
        fmt::format(
            "{}: the run does not contain its scene; play its hand in a scene first, and give that file, as in\n"
            "ghostforce replay RUN.csv wall45 -o told.csv",
            name));
  }
  RecordedHand hand{.name = std::move(name), .scene = *run.scene, .start = {}};
  if (!run.ticks.empty()) {
    hand.scene = scene_since(run, run.ticks.front());
    hand.scene.goal = goal_path_of(run);
  }
  const GoalPath& path = hand.scene.goal;
  if (run.ticks.empty() || path.times.size() < 2) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("{}: the run has no two consecutive ticks, so the hand does not move; give a longer run",
                              hand.name));
  }
  hand.scene.duration = path.times.back();
  hand.scene.settings = run.settings[run.ticks.front().settings];
  hand.start = replay_start(run, run.ticks.front(), hand.scene).state;
  const std::size_t shown = path.times.size();
  std::int64_t jumps = 0;
  for (std::size_t i = 0; i < shown; ++i) {
    const RunTick& tick = run.ticks[i];
    if (i > 0 && tick.settings != run.ticks[i - 1].settings) {
      hand.changes.push_back({path.times[i], run.settings[tick.settings]});
    }
    if (i > 0 && tick.state != RunTick::none) ++jumps;
    hand.is_estimated |= tick.measured.has_value();
  }
  if (jumps > 0) {
    hand.left_out.push_back(fmt::format(
        "{} not shown (motors came on or went off, or samples were lost): the devices are simulated throughout.",
        jumps == 1 ? "A jump of the recorded devices is" : fmt::format("{} jumps of the recorded devices are", jumps)));
  }
  if (shown < run.ticks.size()) {
    hand.left_out.push_back(
        fmt::format("The run was reset after {:.3g} s; what follows is not shown.", path.times.back()));
  }
  return hand;
}

}  // namespace ghostforce
