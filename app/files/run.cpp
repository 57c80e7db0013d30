#include "app/files/run.h"

#include <iterator>

#include <fmt/compile.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"
#include "app/files/program_build.h"
#include "app/files/scene_file.h"
#include "app/files/scene_keys.h"
#include "core/general_tick.h"

namespace ghostforce {

bool RunLength::takes(std::int64_t tick, double rate) noexcept {
  if (rate_ == 0.0 || (rate == rate_ && tick <= last_)) {  // its beginning, or a reset
    begin_ = tick;
    before_ = 0;
  } else if (rate != rate_) {
    before_ += last_ - begin_ + 1;
    begin_ = tick;
  }
  rate_ = rate;
  last_ = tick;
  return static_cast<double>(before_ + (tick - begin_)) <= most_ticks;
}

ReadError too_long(const RunFacts& run, const RunTick& tick) {
  return {ReadError::Kind::wrong,
          {{.file = run.name,
            .line = tick.line,
            .column = 1,
            .what = fmt::format("with t_s = {} here, the run is longer than {:.0f} ticks, which is the limit",
                                tick.time_s, most_ticks),
            .remedy = fmt::format("if that time is wrong, correct the line; if the run really is that long, cut it "
                                  "before this line:\nhead -n {} RUN.csv > shorter.csv",
                                  tick.line - 1)}}};
}

Failure unstable_loop(StrategyId id, double time_s, std::string_view run) {
  const std::string name = quoted_text(run, longest_path);
  return {
      ExitCode::wrong_call,
      fmt::format("{}{}the sampled loop is unstable with these settings: the {} device has run away by t = {:.6g} s; "
                  "lower rendering.k_r_N_per_m, or raise device.rate_hz, device.mass_kg or "
                  "device.damping_N_s_per_m{}",
                  name, name.empty() ? "" : ": ", strategy(id).name, time_s,
                  run.empty() ? "" : ", with\nghostforce replay RUN.csv --set KEY=VALUE -o calm.csv")};
}

std::string provenance(const Scene& scene) {
  std::string header =
      fmt::format("# ghostforce {}\n{}{}\n{}\n", program_build(), format_begins, format_of(scene), scene_begins);
  const std::string text = scene_text(scene);
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view line = take_until(rest, '\n');
    header += line.empty() ? "#\n" : fmt::format("# {}\n", line);
  }
  header += fmt::format("{}\n", scene_ends);
  return header;
}

std::string effort_columns(const Scene& scene) {
  std::string columns;
  if (!is_general(scene.settings)) return columns;
  const std::size_t motors = motor_count(mechanism_of(scene.settings));
  for (std::size_t i = 1; i <= motors; ++i) columns += fmt::format(",effort_{}", i);
  return columns;
}

std::string run_header(const Scene& scene, std::string_view further_columns) {
  const std::string efforts = effort_columns(scene);
  const bool are_torques = !efforts.empty() && makes_torques(mechanism_of(scene.settings));
  return fmt::format(
      "{}"
      "# One row per tick and strategy. Units: s, m, N. The force is that of the device on the hand.{}\n"
      "{}{}{}\n",
      provenance(scene),
      efforts.empty() ? ""
      : are_torques   ? " Efforts are in N·m."
                      : " Efforts are in N.",
      run_columns, further_columns, efforts);
}

void append_state_line(fmt::memory_buffer& rows, double time_s, const RunState& state) {
  const auto out = std::back_inserter(rows);
  fmt::format_to(out, FMT_COMPILE("{}{}{}"), state_begins, time_begins, time_s);
  for (const Strategy& each : strategy_catalog()) {
    const Vector<2>& velocity = state.velocity[index_of(each.id)];
    fmt::format_to(out, FMT_COMPILE(" {}={},{},{}"), each.name, velocity.x, velocity.y,
                   state.energy[index_of(each.id)]);
  }
  rows.push_back('\n');
}

void append_set_lines(fmt::memory_buffer& rows, double time_s, Settings& known, const Settings& wanted) {
  Scene before;
  Scene after;
  before.settings = known;
  after.settings = wanted;
  // No file can say again that nothing is believed. To believe the user's own stiffness is the same.
  Stiffnesses& stiffnesses = after.settings.stiffnesses;
  if (!stiffnesses.believed_k_u && known.stiffnesses.believed_k_u) stiffnesses.believed_k_u = stiffnesses.k_u;
  for (const SceneKey& key : scene_keys()) {
    if (!is_setting(key) || !belongs(key, after)) continue;
    const std::string value = value_text(after, key);
    if (value == value_text(before, key)) continue;
    fmt::format_to(std::back_inserter(rows), FMT_COMPILE("{}{}{} {}={}\n"), set_begins, time_begins, time_s,
                   dotted_name(key), value);
  }
  known = after.settings;
}

void append_efforts(fmt::memory_buffer& rows, const Settings& settings, const Efforts& efforts) {
  if (!is_general(settings)) return;
  const std::size_t motors = motor_count(mechanism_of(settings));
  for (std::size_t i = 0; i < motors; ++i) fmt::format_to(std::back_inserter(rows), FMT_COMPILE(",{}"), efforts[i]);
}

void append_run_row(fmt::memory_buffer& rows, const Snapshot& snapshot, StrategyId id) {
  const StrategySnapshot<2>& state = snapshot.strategies[index_of(id)];
  fmt::format_to(std::back_inserter(rows), FMT_COMPILE("{},{},{},{},{},{},{},{},{},{}"), strategy(id).name,
                 snapshot.time_s, snapshot.goal.x, snapshot.goal.y, state.device.x, state.device.y, state.proxy.x,
                 state.proxy.y, state.force.x, state.force.y);
}

}  // namespace ghostforce
