// A sweep as CSV: comment lines with version, scene and ranges, one line of column names, then one row per point and
// strategy. Numbers in the shortest form that reads back exactly, whatever the locale. Pure, any thread; not for the
// servo thread (it allocates).
#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "app/tools/sweep/grid.h"
#include "app/tools/sweep/point_equilibrium.h"

namespace ghostforce {

// All that stands before the first row.
std::string sweep_header(const Scene& scene, const Grid& grid, const EquilibriumKind& kind);

// The rows of a point, each with its newline.
void append_sweep_rows(fmt::memory_buffer& rows, const Grid& grid, std::int64_t point, const PointEquilibrium& rest,
                       const EquilibriumKind& kind);

}  // namespace ghostforce
