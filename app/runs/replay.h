// A run driven once more through the tick: does the same build make the same numbers of the same hand and settings, bit
// for bit? Not for the servo thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "app/files/run.h"
#include "core/snapshot.h"
#include "core/tick.h"

namespace ghostforce {

// Where the run and its replay first part.
struct Divergence {
  double time_s = 0.0;
  StrategyId strategy = StrategyId::full;
  std::string_view column;  // of the file
  double recorded = 0.0;    // in the column's unit
  double replayed = 0.0;
};

struct ReplayReport {
  std::int64_t compared = 0;   // ticks
  std::int64_t diverging = 0;  // of these
  std::int64_t measured = 0;   // of these: their measured device was taken over, not compared
  std::int64_t skipped = 0;    // ticks that cannot be known: something before them is missing
  std::int64_t resumed = 0;    // times that it went on from a recorded state
  std::optional<Divergence> first;
  double greatest_m = 0.0;  // difference of a goal, a device or a proxy
  double greatest_N = 0.0;  // and of a force
};

// A tick of the replay. `state`: it goes on from there; null: from the tick before.
struct ReplayedTick {
  const Snapshot& snapshot;
  const Settings& settings;
  const RunState* state;
  PerStrategy<bool> is_known;  // whose numbers follow from the run; others mean nothing
};

// Takes a run tick by tick, so that its length does not matter. Goes on through divergences, on its own numbers.
class Replay {
 public:
  explicit Replay(std::function<void(const ReplayedTick&)> on_tick) : on_tick_(std::move(on_tick)) {}

  // In the file's order. The run must tell its scene.
  void take(const RunFacts& run, const RunTick& tick);

  const ReplayReport& report() const noexcept { return report_; }

 private:
  bool go_to(const RunTick& tick, const Settings& settings, const RunState* state);
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

}  // namespace ghostforce
