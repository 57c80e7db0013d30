// A run read back: what `simulate`, `replay` and recordings write (run_file.h). Reads as far as the file is sound, and
// says what it had to leave out: a file that was cut, has damaged lines or numbers that are none, or comes from another
// version, is still worth something. Not for the servo thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/run_file.h"
#include "core/scene.h"
#include "core/strategy.h"

namespace ghostforce {

// One row of the file.
struct RunRow {
  Vector<2> device{0.0};  // q_h [m]
  Vector<2> proxy{0.0};   // q_p [m]
  Vector<2> force{0.0};   // f_r [N]
  // Of the strategy on a real device: what went to the motors after every limit, at the handle [N]; empty: not told.
  std::optional<Vector<2>> sent{};
  bool is_saturated = false;  // the limit has shortened it
};

struct RunTick {
  static constexpr std::uint32_t none = UINT32_MAX;

  std::int64_t tick = 0;               // k; t_k = k / rate. Where there is no scene: how manieth tick it is
  double time_s = 0.0;                 // t_k, as the file has it
  Vector<2> goal{0.0};                 // q_u [m]
  std::optional<StrategyId> measured;  // whose device is a real one; the goal is then an estimate
  bool is_sure = true;                 // false: damaged lines may have told of other settings or of a jump
  std::uint32_t state = none;          // of RunFacts::states: it does not follow from the tick before; none: it does
  PerStrategy<std::optional<RunRow>> rows{};  // empty: not in the file, or not sound
  std::size_t settings = 0;                   // of RunFacts::settings, those in use
  std::size_t line = 0;                       // of the file, where its first row is; counted from 1
};

// What a run tells beside its ticks.
struct RunFacts {
  std::string name;                  // what messages call it
  std::string version;               // of the program that wrote it; empty: not told
  std::optional<Scene> scene;        // empty: not told, or not readable
  std::vector<Settings> settings;    // the scene's, then one more for each change while it ran; empty without a scene
  std::vector<RunState> states;      // from which it went on where it was reset, or motors came on or went off
  std::uint64_t dropped = 0;         // samples that were lost while it was recorded
  bool is_interrupted = false;       // the program was, while it was recorded
  std::vector<std::string> remarks;  // what was left out, one line each, for people
};

struct Run : RunFacts {
  std::vector<RunTick> ticks;  // in the file's order; k may jump where rows are missing or the run was reset
};

// Takes one tick after the other. `run` is what was told up to there; its remarks come with the end.
using TakeTick = std::function<void(const RunFacts& run, const RunTick& tick)>;

// Whether a file is rather a run than a scene: by its ending.
bool may_be_run(std::string_view path) noexcept;

// `shown_path` is what remarks and messages call the file. Throws Failure(wrong_call) where the text is no run at all,
// or one that is longer than a scene may be (most_ticks), which a damaged time makes of it.
Run read_run(std::string_view text, std::string_view shown_path);

// With progress on a terminal. Every tick is kept: about 1.2 GB for an hour at 1 kHz. Throws Failure: file_trouble
// where the file cannot be read, or its ticks have no room in the memory; wrong_call as above; interrupted.
Run load_run(const std::string& path);

// The same without keeping a tick, however long the run is. `doing` is what the progress on a terminal is called.
RunFacts stream_run(const std::string& path, std::string_view doing, bool shows_progress, const TakeTick& take);

}  // namespace ghostforce
