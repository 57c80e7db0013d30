// The hand of a run, played once more: the way that it went, and where it begins, from the state that was recorded,
// where that holds, else at rest. Pure, any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "app/files/run.h"
#include "core/goal_path.h"
#include "core/tick.h"

namespace ghostforce {

// The hand as a path that starts at 0 s, made while the run is read: one waypoint per tick, up to where the run was
// reset if it was.
class HandPath {
 public:
  // `rate`: that of the loop that plays it [Hz]; 0: the run's own, with which its length was looked at already.
  explicit HandPath(double rate) : rate_(rate) {}

  // In the file's order. Throws ReadError(wrong) where the path gets longer than a scene may be (most_ticks).
  void take(const RunFacts& run, const RunTick& tick);

  // What it is so far; gives it away.
  GoalPath take_path() { return std::move(path_); }

 private:
  double time_of_tick(const RunFacts& run, const RunTick& tick);

  double rate_;
  GoalPath path_;
  bool is_over_ = false;
  // Where the stretch with the same rate begins.
  double stretch_rate_ = 0.0;  // 0: no tick yet
  std::int64_t begin_ = 0;     // k
  double begin_s_ = 0.0;       // on the path
  double first_s_ = 0.0;       // of the run, where there is no rate
};

// The path of a whole run. Throws ReadError as HandPath does, and Failure(wrong_call) where there is no tick.
GoalPath goal_path_of(const Run& run, double rate = 0.0);

// What measures the hand at a simulated device, from this tick to the next [N]; a real one has it in its place already.
// `strategy`: its index.
Vector<2> tone_on_simulated(const RunTick& tick, std::size_t strategy) noexcept;

// The state of a tick that has one. Strategies without a row stay at 0.
TickState<2> recorded_state(const RunTick& tick, const RunState& state);

// The run's scene for its own hand when that is played from 0 s on: as stiff as it was in the run, whose first tick is
// `first`. The run must tell its scene.
Scene scene_since(const RunFacts& run, const RunTick& first);

// k = 0. `scene`: the one that it will be played in; a state that was recorded under other settings is of no use to
// these, nor is a real device's to a simulated one. `first`: the run's first tick.
struct ReplayStart {
  TickState<2> state;
  bool is_recorded;  // else at rest
};
ReplayStart replay_start(const RunFacts& run, const RunTick& first, const Scene& scene);

}  // namespace ghostforce
