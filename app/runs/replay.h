// A run driven once more through the tick: does the same build make the same numbers of the same hand and settings, bit
// for bit, and another one numbers that are the same but for rounding? And its hand alone, as a path that another scene
// can play. Pure, but not for the servo thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "app/files/run.h"
#include "core/general_tick.h"
#include "core/goal_path.h"
#include "core/snapshot.h"
#include "core/tick.h"

namespace ghostforce {

// What is compared. Its x and y, and those of all strategies, are measured with one scale: a component that is zero but
// for rounding would have none.
enum class ReplayedQuantity : std::uint8_t { time, device, proxy, force };
inline constexpr std::size_t replayed_quantity_count = 4;

// A value of the run that is another in its replay.
struct Divergence {
  double time_s = 0.0;
  StrategyId strategy = StrategyId::full;
  std::string_view column;  // of the file
  double recorded = 0.0;    // in the column's unit
  double replayed = 0.0;

  double difference() const noexcept;  // infinite where one of them is no number
};

// How far a quantity is off over the whole run.
struct Deviation {
  std::optional<Divergence> greatest;  // none: the same to the last bit
  // The greatest value that the replay makes of it: were it the run's, a damaged value would excuse itself.
  double magnitude = 0.0;

  double relative() const noexcept;  // the greatest difference over the magnitude
};

struct ReplayReport {
  std::int64_t compared = 0;   // ticks
  std::int64_t diverging = 0;  // of these
  std::int64_t measured = 0;   // of these: their measured device was taken over, not compared
  std::int64_t skipped = 0;    // ticks that cannot be known: something before them is missing
  std::int64_t resumed = 0;    // times that it went on from a recorded state
  // When a device of which the run has no rows ran away. Its rows end there: the run is no worse for it.
  PerStrategy<std::optional<double>> ran_away_s{};
  std::optional<Divergence> first;
  std::array<Deviation, replayed_quantity_count> deviations;

  const Deviation& of(ReplayedQuantity quantity) const { return deviations[static_cast<std::size_t>(quantity)]; }
  const Deviation& worst() const;  // relative to its magnitude
};

// By how much a run of another build may differ, relative to the magnitude of each quantity. Compilers, processors and
// libraries round sines and sums differently in the last bit, 1e-16, and the damped loop does not let that grow.
inline constexpr double replay_tolerance = 1e-12;

enum class Agreement : std::uint8_t {
  unknown,    // nothing could be compared
  identical,  // bit for bit
  close,      // within the tolerance, and of another build
  diverging,
};

// What the report means for a run that says which build wrote it: the same one must repeat every bit.
Agreement agreement(const RunFacts& run, const ReplayReport& report);

// A tick of the replay. `state`: it goes on from there; null: from the tick before.
struct ReplayedTick {
  const Snapshot& snapshot;
  const Settings& settings;
  const RunState* state;
  PerStrategy<bool> is_known;    // whose numbers follow from the run; others mean nothing
  PerStrategy<Vector<2>> tones;  // at simulated devices, until the next tick [N]
  ContactReadings contacts;      // in general scenes
};

// Takes a run tick by tick, so that its length does not matter. Goes on through divergences, on its own numbers.
class Replay {
 public:
  explicit Replay(std::function<void(const ReplayedTick&)> on_tick = {}) : on_tick_(std::move(on_tick)) {}

  // In the file's order. The run must tell its scene.
  void take(const RunFacts& run, const RunTick& tick);

  const ReplayReport& report() const noexcept { return report_; }

 private:
  bool go_to(const RunTick& tick, const Settings& settings, const StiffnessPath& stiffness, const RunState* state);
  void use(const Settings& settings);
  void follow(const RunTick& now);
  bool is_any_known() const noexcept;
  bool compare_row(const RunTick& tick, const Snapshot& snapshot, StrategyId id);

  std::function<void(const ReplayedTick&)> on_tick_;
  ReplayReport report_;
  std::optional<Settings> settings_;  // of the coefficients
  LoopCoefficients coefficients_{};
  TickState<2> state_;
  PerStrategy<bool> is_known_{};
  bool is_first_ = true;
};

// A whole run that is held in memory. It must tell its scene.
ReplayReport replay(const Run& run, const std::function<void(const ReplayedTick&)>& on_tick = {});

// The hand of a run as a path that starts at 0 s, made while the run is read: one waypoint per tick, up to where the
// run was reset if it was.
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

struct ReplayStart {
  TickState<2> state;  // k = 0
  bool is_recorded;    // else at rest
};

// Where the hand of a run begins when it is played in `scene`: from the state that was recorded, where that holds, else
// at rest. A state that was recorded under other settings is of no use to these, nor is a real device's to a simulated
// one. `first`: the run's first tick.
ReplayStart replay_start(const RunFacts& run, const RunTick& first, const Scene& scene);

}  // namespace ghostforce
