// A run as CSV: comment lines with the program's build and the scene, one line of column names, then one row per tick
// and strategy. SI units; numbers in the shortest form that reads back exactly, whatever the locale. Pure; not for the
// servo thread (it allocates).
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "app/files/run.h"
#include "core/scene.h"
#include "core/snapshot.h"

namespace ghostforce {

inline constexpr std::string_view run_columns =
    "strategy,t_s,goal_x_m,goal_y_m,device_x_m,device_y_m,proxy_x_m,proxy_y_m,force_x_N,force_y_N";

// What recordings add. sent: after the safety chain [N]; loop_s: real time since the tick before [s]; tone: what measures
// the hand, on the active device until the next tick [N]: part of what is sent to a real one, beside the force of a
// simulated one, 0 where nothing measures.
inline constexpr std::string_view recording_columns =
    ",active,goal_kind,device_kind,sent_x_N,sent_y_N,saturated,loop_s,tone_x_N,tone_y_N";

// What replays of such recordings add, so that they can be replayed too.
inline constexpr std::string_view tone_columns = ",tone_x_N,tone_y_N";

// How the line of the format's number begins. A reader that knows a lower one refuses the file.
inline constexpr std::string_view format_begins = "# format ";
inline constexpr int run_format = 1;

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

// All that stands before the first row. `further_columns` come after the common ones: "" or ",name,name…".
std::string run_header(const Scene& scene, std::string_view further_columns = {});

void append_state_line(fmt::memory_buffer& rows, double time_s, const RunState& state);

// A line for each key of the settings that a reader who knows `known` must hear of to know `wanted`, which must come
// from a file or from rounded_to_file() to be known exactly. `known` becomes what the reader knows then.
void append_set_lines(fmt::memory_buffer& rows, double time_s, Settings& known, const Settings& wanted);

// One row of run_columns, without a newline, so that further values can follow.
void append_run_row(fmt::memory_buffer& rows, const Snapshot& snapshot, StrategyId strategy);

}  // namespace ghostforce
