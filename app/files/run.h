// A run as values: what `simulate`, `replay` and recordings write (run_file.h), as it is read back (run_reader.h); and
// how long one may be. SI units. Pure, any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "app/files/read_error.h"
#include "core/scene.h"
#include "core/strategy.h"

namespace ghostforce {

// What a run cannot tell with a row for each tick.
struct RunState {
  PerStrategy<Vector<2>> velocity{};  // v [m/s]
  PerStrategy<double> energy{};       // W [J]
};

// One row of the file.
struct RunRow {
  Vector<2> device{0.0};  // q_h [m]
  Vector<2> proxy{0.0};   // q_p [m]
  Vector<2> force{0.0};   // f_r [N]
  // Of the strategy on a real device: what went to the motors after every limit, at the handle [N]; empty: not told.
  std::optional<Vector<2>> sent{};
  bool is_saturated = false;  // the limit has shortened it
  Vector<2> tone{0.0};        // what measures the hand, until the next tick [N]
};

struct RunTick {
  static constexpr std::uint32_t none = UINT32_MAX;

  std::int64_t tick = 0;               // k; t_k = k / rate. Where there is no scene: the number of the tick
  double time_s = 0.0;                 // t_k, as the file has it
  Vector<2> goal{0.0};                 // q_u [m]
  double loop_s = 0.0;                 // real time since the tick before; 0: not told
  std::optional<StrategyId> measured;  // whose device is a real one; the goal is then an estimate
  std::uint32_t state = none;          // of RunFacts::states: it does not follow from the tick before; none: it does
  PerStrategy<std::optional<RunRow>> rows{};  // empty: not in the file
  std::size_t settings = 0;                   // of RunFacts::settings, those in use
  std::size_t line = 0;                       // of the file, where its first row is; counted from 1
};

// What a run tells beside its ticks.
struct RunFacts {
  std::string name;                   // what messages call it
  std::string version;                // of the program that wrote it, as program_build() tells it; empty: not told
  std::optional<Scene> scene;         // empty: not told
  std::vector<Settings> settings;     // the scene's, then one more for each change while it ran; empty without a scene
  std::vector<RunState> states;       // from which it went on where it was reset, or motors came on or went off
  std::uint64_t dropped = 0;          // samples that were lost while it was recorded
  bool is_interrupted = false;        // the program was, while it was recorded
  bool tells_tones = false;           // there are columns of what measured the hand
  std::vector<std::string> warnings;  // what is not told or was lost, one line each, for people
};

struct Run : RunFacts {
  // In the file's order: later and later, but where a state begins; k may jump where rows are missing. Grows without
  // being copied.
  std::deque<RunTick> ticks;
};

// How long a run is in ticks, those without a row included: what is made of a run plays all of them. The rule for a
// scene's duration (most_ticks) holds for it too, or one damaged time would be work without end. Counts from where the
// run began, or was reset last.
class RunLength {
 public:
  // The next tick of the file: its k, and the rate there. False: with it the run is longer than may be.
  bool takes(std::int64_t tick, double rate) noexcept;

 private:
  std::int64_t begin_ = 0;   // k where the stretch with the same rate begins
  std::int64_t last_ = 0;    // k
  std::int64_t before_ = 0;  // ticks before that stretch
  double rate_ = 0.0;        // 0: no tick yet
};

// What to say of the first tick that is too far off.
ReadError too_long(const RunFacts& run, const RunTick& tick);

}  // namespace ghostforce
