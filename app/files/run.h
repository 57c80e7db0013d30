// A run: what `simulate`, `replay` and recordings write, as values that are read back (run_reader.h) and as the text of
// its file; and how long one may be.
//
// The file is CSV: comment lines with the program's build and the scene, one line of column names, then one row per
// tick and strategy. SI units; numbers in the shortest form that reads back exactly, whatever the locale. Pure; any
// thread but the servo's, because most of it allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/files/read_error.h"
#include "core/scene.h"
#include "core/snapshot.h"
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
  Efforts efforts{};          // u of each motor, in general scenes [N or N·m]
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

// What ends the work with a loop that has run away (core/divergence.h), by `time_s`. `run`: the file that it is in, or
// whose hand is played; empty: a scene's own.
Failure unstable_loop(StrategyId strategy, double time_s, std::string_view run = {});

// The columns that every run has.
inline constexpr std::string_view run_columns =
    "strategy,t_s,goal_x_m,goal_y_m,device_x_m,device_y_m,proxy_x_m,proxy_y_m,force_x_N,force_y_N";

// What recordings add. sent: after the safety chain [N]; loop_s: real time since the tick before [s]; tone: what
// measures the hand, on the active device until the next tick [N]: part of what is sent to a real one, beside the force
// of a simulated one, 0 where nothing measures.
inline constexpr std::string_view recording_columns =
    ",active,goal_kind,device_kind,sent_x_N,sent_y_N,saturated,loop_s,tone_x_N,tone_y_N";

// What replays of such recordings add, so that they can be replayed too.
inline constexpr std::string_view tone_columns = ",tone_x_N,tone_y_N";

// How the line of the format's number begins. A reader that knows a lower one refuses the file.
inline constexpr std::string_view format_begins = "# format ";
inline constexpr int run_format = 2;  // the highest; a run of a scene of format 1 is of format 1

// The columns that a run of a general scene adds after all others, one per motor: effort_1 …; empty for other scenes.
std::string effort_columns(const Scene& scene);

// The lines between which the scene stands, each of its lines after "# ".
inline constexpr std::string_view scene_begins = "# scene:";
inline constexpr std::string_view scene_ends = "# end of scene";

// How the lines between the rows of a recording begin, and its last line where the program was interrupted.
//     # set t_s=T KEY=VALUE            from T on, as --set takes it
//     # state t_s=T STRATEGY=VX,VY,W…  the rows at T do not follow from those before: velocity [m/s], energy W [J]
//     # dropped N                      samples lost here
inline constexpr std::string_view set_begins = "# set ";
inline constexpr std::string_view state_begins = "# state ";
inline constexpr std::string_view dropped_begins = "# dropped ";
inline constexpr std::string_view interrupted_line = "# interrupted";
// After the header of a run whose hand came from another file.
inline constexpr std::string_view hand_begins = "# hand from ";
// What stands before the arguments of "# set" and "# state".
inline constexpr std::string_view time_begins = "t_s=";

// What each file of rows begins with: the program's build (program_build.h), the format's number and the scene,
// as comments.
std::string provenance(const Scene& scene);

// All that stands before the first row. `further_columns` come after the common ones: "" or ",name,name…"; after them
// those of the motors' efforts.
std::string run_header(const Scene& scene, std::string_view further_columns = {});

void append_state_line(fmt::memory_buffer& rows, double time_s, const RunState& state);

// A line for each key of the settings that a reader who knows `known` must hear of to know `wanted`, which must come
// from a file or from rounded_to_file() to be known exactly. `known` becomes what the reader knows then.
void append_set_lines(fmt::memory_buffer& rows, double time_s, Settings& known, const Settings& wanted);

// One row of run_columns, without a newline, so that further values can follow.
void append_run_row(fmt::memory_buffer& rows, const Snapshot& snapshot, StrategyId strategy);

// The values of effort_columns(), each after its comma; none where the settings are not of a general scene.
void append_efforts(fmt::memory_buffer& rows, const Settings& settings, const Efforts& efforts);

}  // namespace ghostforce
