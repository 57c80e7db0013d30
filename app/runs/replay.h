// A run driven once more through the tick: does the same build make the same numbers of the same hand and settings, bit
// for bit, and another one numbers that are the same but for rounding? Not for the servo thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "app/files/run.h"
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
  TickCoefficients<2> coefficients_{};
  TickState<2> state_;
  PerStrategy<bool> is_known_{};
  bool is_first_ = true;
};

// A whole run that is held in memory. It must tell its scene.
ReplayReport replay(const Run& run, const std::function<void(const ReplayedTick&)>& on_tick = {});

}  // namespace ghostforce
