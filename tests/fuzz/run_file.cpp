// A run: whatever is in the file, what is read of it is whole, and can be driven once more.
#include <algorithm>
#include <cmath>

#include "app/base/failure.h"
#include "app/files/run_reader.h"
#include "app/runs/replay.h"
#include "tests/fuzz/fuzz.h"

using namespace ghostforce;

namespace {

bool is_finite(const Vector<2>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}

void look_at(const Run& run, const RunTick& tick) {
  require(std::isfinite(tick.time_s) && is_finite(tick.goal), "a tick has a time and a goal");
  require(tick.state == RunTick::none || tick.state < run.states.size(), "a tick's state is there");
  require(!run.scene || tick.settings < run.settings.size(), "a tick's settings are there");
  for (const std::optional<RunRow>& row : tick.rows) {
    require(!row || (is_finite(row->device) && is_finite(row->proxy) && is_finite(row->force)),
            "a row's numbers are numbers");
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Run run;
  try {
    run = read_run(text_of({data, size}), "fuzz.csv");
  } catch (const Failure& failure) {
    require(failure.code() == ExitCode::wrong_call, "a scene that says something wrong is a wrong call");
    return 0;
  } catch (const ReadError& error) {
    require(error.kind() == ReadError::Kind::wrong, "a file that is no run says something wrong");
    return 0;
  }
  for (const RunTick& tick : run.ticks) look_at(run, tick);
  for (const Settings& settings : run.settings) require(is_in_range(settings), "settings are in range");
  if (!run.scene || run.ticks.empty()) return 0;

  const GoalPath path = goal_path_of(run);
  require(!path.points.empty() && path.points.size() == path.times.size(), "there are as many times as places");
  require(path.times.front() == 0.0, "the hand's path starts at 0 s");
  require(std::ranges::adjacent_find(path.times, std::greater_equal()) == path.times.end(), "its times increase");
  const ReplayReport report = replay(run, [](const ReplayedTick&) {});
  require(report.diverging <= report.compared && report.compared >= 0 && report.skipped >= 0,
          "no more ticks part than were compared");
  return 0;
}
