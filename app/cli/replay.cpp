// ghostforce replay: a recorded hand once more, bit for bit, or in another scene.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/base/words.h"
#include "app/cli/command.h"
#include "app/cli/option.h"
#include "app/files/output_file.h"
#include "app/files/program_build.h"
#include "app/files/run.h"
#include "app/files/run_reader.h"
#include "app/files/scene_file.h"
#include "app/runs/replay.h"
#include "core/divergence.h"

namespace ghostforce {
namespace {

struct ReplayOptions {
  std::string run;
  SceneOptions scene;  // not named: the run's own
  std::string output = "-";
};

// "1 tick", "2 ticks"
std::string ticks(std::int64_t count) {
  return fmt::format("{} {}", count, count == 1 ? "tick" : "ticks");
}

// --- The run as it was ---

double greatest(const ReplayReport& report, ReplayedQuantity quantity) {
  const std::optional<Divergence>& divergence = report.of(quantity).greatest;
  return divergence ? divergence->difference() : 0.0;
}

std::string divergence_words(const ReplayReport& report) {
  using enum ReplayedQuantity;
  const Divergence& first = *report.first;
  return fmt::format(
      "diverges at t = {} s: {} of {} is {} in the run and {} here, a difference of {:.3g}; {} of {} differ, by at "
      "most {:.3g} m and {:.3g} N",
      first.time_s, first.column, strategy(first.strategy).name, first.recorded, first.replayed, first.difference(),
      report.diverging, ticks(report.compared), std::max(greatest(report, device), greatest(report, proxy)),
      greatest(report, force));
}

std::string agreement_words(const RunFacts& run, const ReplayReport& report) {
  switch (agreement(run, report)) {
    case Agreement::unknown:
      return "nothing can be compared: the state from which the run continues is not known";
    case Agreement::identical:
      return fmt::format("identical bit for bit for {}", ticks(report.compared));
    case Agreement::close:
      return fmt::format("agrees to {:.2g} relative for {}, not bit for bit: recorded by another build ({})",
                         report.worst().relative(), ticks(report.compared),
                         run.version.empty() ? "it does not say which" : "ghostforce " + quoted_text(run.version));
    case Agreement::diverging:
      break;
  }
  return divergence_words(report);
}

// What may differ depends on the build that wrote the run.
std::string promise_words(const RunFacts& run, const ReplayReport& report) {
  const Deviation& worst = report.worst();
  if (worst.relative() <= replay_tolerance) {
    return fmt::format(
        "\nit agrees to {:.2g} relative. That is enough for a run of another build, but the file names this one. "
        "Builds "
        "of one version by another compiler or for another processor have the same name",
        worst.relative());
  }
  if (run.version == program_build()) return {};
  return fmt::format(
      "\nexact replay is promised only for the same version; a run of another build may differ by {} relative, and "
      "this one differs by {:.2g} at t = {} s in {} of {}",
      replay_tolerance, worst.relative(), worst.greatest->time_s, worst.greatest->column,
      strategy(worst.greatest->strategy).name);
}

std::string verdict(const RunFacts& run, const ReplayReport& report) {
  std::string words = agreement_words(run, report);
  if (report.measured > 0) {
    words += fmt::format("\nin {} a device was measured; only the simulated ones are compared there",
                         ticks(report.measured));
  }
  if (report.skipped > 0 && report.compared > 0) {
    words += fmt::format("\n{} left out, because the state before is missing",
                         report.skipped == 1 ? "1 tick is" : fmt::format("{} ticks are", report.skipped));
  }
  if (run.dropped > 0) {
    words += fmt::format(
        "\n{} samples were lost while recording; the comparison stops at each loss and starts again after it",
        run.dropped);
  }
  for (const Strategy& each : strategy_catalog()) {
    if (const auto time_s = report.ran_away_s[index_of(each.id)]) {
      words += fmt::format(
          "\nthe {} device, of which the run has no rows there, has run away by t = {:.6g} s; its rows end there",
          each.name, *time_s);
    }
  }
  if (agreement(run, report) == Agreement::diverging) words += promise_words(run, report);
  return words;
}

// What was left out comes before any verdict.
void tell_remarks(const RunFacts& run) {
  for (const std::string& warning : run.warnings) say("{}\n", warning);
}

[[noreturn]] void refuse(const ReplayOptions& options, std::string_view why) {
  throw Failure(ExitCode::wrong_call, fmt::format("{}: {}", quoted_text(options.run, longest_path), why));
}

constexpr std::string_view no_scene = "the run does not contain its scene; name a scene to replay its hand in";
constexpr std::string_view no_tick = "there is nothing to replay";

int replay_exactly(const ReplayOptions& options) {
  OutputFile file(options.output);
  fmt::memory_buffer lines;
  Settings known;
  std::optional<Settings> newest;
  bool tells_tones = false;
  Replay replay([&](const ReplayedTick& tick) {
    for (const Strategy& each : strategy_catalog()) {
      if (!tick.is_known[index_of(each.id)] || !has_diverged(tick.snapshot.strategies[index_of(each.id)])) continue;
      end_unstable(file, each.id, tick.snapshot.time_s, options.run);
    }
    if (newest != tick.settings) {
      append_set_lines(lines, tick.snapshot.time_s, known, tick.settings);
      newest = tick.settings;
    }
    if (tick.state != nullptr) append_state_line(lines, tick.snapshot.time_s, *tick.state);
    for (const Strategy& each : strategy_catalog()) {
      if (!tick.is_known[index_of(each.id)]) continue;
      append_run_row(lines, tick.snapshot, each.id);
      const Vector<2>& tone = tick.tones[index_of(each.id)];
      if (tells_tones) fmt::format_to(std::back_inserter(lines), FMT_COMPILE(",{},{}"), tone.x, tone.y);
      append_efforts(lines, tick.settings, tick.contacts[index_of(each.id)].efforts);
      lines.push_back('\n');
    }
    file.write({lines.data(), lines.size()});
    lines.clear();
  });
  bool is_begun = false;
  const RunFacts run =
      stream_run(options.run, "replaying", !file.is_terminal(), [&](const RunFacts& so_far, const RunTick& tick) {
        if (!so_far.scene) return;  // said below, after why
        if (!std::exchange(is_begun, true)) {
          tells_tones = so_far.tells_tones;
          file.write(run_header(*so_far.scene, tells_tones ? tone_columns : std::string_view()));
          known = so_far.scene->settings;
        }
        replay.take(so_far, tick);
      });
  tell_remarks(run);
  if (!run.scene) refuse(options, no_scene);
  if (!is_begun) refuse(options, no_tick);
  file.commit();
  const ReplayReport& report = replay.report();
  say("{}: {}\n", quoted_text(options.run, longest_path), verdict(run, report));
  const Agreement is = agreement(run, report);
  return static_cast<int>(is == Agreement::identical || is == Agreement::close ? ExitCode::done
                                                                               : ExitCode::answer_is_no);
}

// --- Its hand in another scene ---

// The run's own is known once its first tick comes. None: it tells none.
std::optional<Scene> other_scene(const RunFacts& run, const RunTick& first, const ReplayOptions& options) {
  if (options.scene.is_named()) return options.scene.load();
  if (!run.scene) return std::nullopt;
  return read_scene(scene_text(scene_since(run, first)), options.run, options.scene.overrides);
}

// All that is needed of a run to play its hand: of its ticks the goals alone.
struct ReplayedHand {
  Scene scene;  // that it is played in
  ReplayStart start;
  GoalPath path;
};

ReplayedHand load_hand(const ReplayOptions& options) {
  std::optional<ReplayedHand> hand;
  std::optional<HandPath> path;
  bool is_empty = true;
  const RunFacts run = stream_run(options.run, "reading", true, [&](const RunFacts& so_far, const RunTick& tick) {
    if (std::exchange(is_empty, false)) {
      if (std::optional<Scene> scene = other_scene(so_far, tick, options)) {
        scene->tremor_and_drift = {};  // the recorded hand has its own
        hand = ReplayedHand{*scene, replay_start(so_far, tick, *scene), {}};
        path.emplace(scene->settings.rate);
      }
    }
    if (path) path->take(so_far, tick);
  });
  tell_remarks(run);
  if (is_empty) refuse(options, no_tick);
  if (!hand) refuse(options, no_scene);
  hand->path = path->take_path();
  return *std::move(hand);
}

bool starts_where_hand_is(const TickState<2>& state) {
  return std::ranges::all_of(state.strategies, [&](const TickState<2>::StrategyState& now) {
    return now.motion.position == state.goal && now.proxy == state.goal && now.motion.velocity == Vector<2>(0.0) &&
           now.energy == 0.0;
  });
}

RunState run_state_of(const TickState<2>& state) {
  RunState told;
  for (std::size_t i = 0; i < strategy_count; ++i) {
    told.velocity[i] = state.strategies[i].motion.velocity;
    told.energy[i] = state.strategies[i].energy;
  }
  return told;
}

int replay_hand(const ReplayOptions& options) {
  OutputFile file(options.output);
  ReplayedHand hand = load_hand(options);
  file.write(run_header(hand.scene));
  file.write(fmt::format("{}{}\n", hand_begins, quoted_text(options.run, longest_path)));
  Scene played = std::move(hand.scene);
  played.goal = std::move(hand.path);
  const double end_s = played.goal.times.back();
  constexpr double rounding = 1e-6;  // of the last tick's time, in ticks
  const auto last = static_cast<std::int64_t>(std::floor(end_s * played.settings.rate + rounding));
  // A file without this line begins with every device where the hand is.
  if (!starts_where_hand_is(hand.start.state)) {
    fmt::memory_buffer line;
    append_state_line(line, 0.0, run_state_of(hand.start.state));
    file.write({line.data(), line.size()});
  }
  std::vector<StrategyId> ids;
  for (const Strategy& each : strategy_catalog()) ids.push_back(each.id);
  write_played(file, "replaying", played, hand.start.state, last, ids);
  file.commit();
  say("{}: nothing was compared, because a scene or settings were given. The hand was played from {} for {} s, without "
      "the changes that were made live.\n",
      quoted_text(options.run, longest_path), hand.start.is_recorded ? "the recorded state" : "rest", end_s);
  return static_cast<int>(ExitCode::done);
}

int replay_run(const ReplayOptions& options) {
  const bool is_as_recorded = !options.scene.is_named() && options.scene.overrides.empty();
  return is_as_recorded ? replay_exactly(options) : replay_hand(options);
}

}  // namespace

std::function<int()> attach_replay(CLI::App& command, FileOptions& files) {
  const auto options = std::make_shared<ReplayOptions>();
  files.reads(
      add_option(command, "RUN", options->run, "A CSV file from a recording, 'simulate' or 'replay'")->required());
  options->scene.scene.clear();
  options->scene.attach(command, files, false);
  files.writes(add_option(command, "-o,--output FILE", options->output,
                          "The CSV file to write, whole or not at all; default: -, standard output"));
  return [options] { return replay_run(*options); };
}

}  // namespace ghostforce
