// A run as CSV: comment lines with the program's version and the scene, one line
// of column names, then one row per tick and strategy. SI units; numbers in the
// shortest form that reads back exactly, whatever the locale. Pure; not for the
// servo thread (it allocates).
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/scene.h"
#include "core/snapshot.h"

namespace ghostforce {

inline constexpr std::string_view run_columns =
    "strategy,t_s,goal_x_m,goal_y_m,device_x_m,device_y_m,proxy_x_m,proxy_y_m,force_x_N,force_y_N";

// The lines between which the scene stands, each of its lines after "# ".
inline constexpr std::string_view scene_begins = "# scene:";
inline constexpr std::string_view scene_ends = "# end of scene";

// All that stands before the first row. `further_columns` come after the common
// ones: "" or ",name,name…".
std::string run_header(const Scene& scene, std::string_view further_columns = {});

// One row of run_columns, without a newline, so that further values can follow.
void append_run_row(fmt::memory_buffer& rows, const Snapshot& snapshot, StrategyId strategy);

}  // namespace ghostforce
