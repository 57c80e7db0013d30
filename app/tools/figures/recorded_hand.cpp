#include "app/tools/figures/recorded_hand.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/runs/replay_start.h"

namespace ghostforce {

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
