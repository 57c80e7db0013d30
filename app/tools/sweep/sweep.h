// A sweep on all cores: every point of a grid at rest, as rows in the grid's order, the same bytes however many threads
// there are. Holds some blocks of points at a time, never the whole sweep. It is written as CSV: comment lines with
// version, scene and ranges, one line of column names, then one row per point and strategy. Numbers are in the shortest
// form that reads back exactly, whatever the locale. Not for the servo thread (it allocates).
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "app/tools/sweep/grid.h"
#include "app/tools/sweep/point_equilibrium.h"

namespace ghostforce {

// The rows of some points, whole, and how long they took on the thread that made them.
struct SweptBlock {
  std::string_view rows;
  std::int64_t points = 0;                 // swept so far, these included
  std::int64_t unsettled = 0;              // of these rows: their loop does not come to rest
  std::chrono::nanoseconds computing{0};   // the rests
  std::chrono::nanoseconds formatting{0};  // numbers to text
};

struct SweepPlan {
  const Scene& scene;
  const Grid& grid;
  const EquilibriumKind& kind;
};

// Threads that this machine has a core for.
std::size_t sweep_threads() noexcept;

// Hands every block to `take`, on this thread. Stops after the last whole row when the program is interrupted
// (interruption.h), and returns whether it got to the end.
bool sweep(const SweepPlan& plan, std::size_t thread_count, const std::function<void(const SweptBlock&)>& take);

// All that stands before the first row. Pure.
std::string sweep_header(const Scene& scene, const Grid& grid, const EquilibriumKind& kind);

// The rows of a point, each with its newline. Pure.
void append_sweep_rows(fmt::memory_buffer& rows, const Grid& grid, std::int64_t point, const PointEquilibrium& rest,
                       const EquilibriumKind& kind);

}  // namespace ghostforce
