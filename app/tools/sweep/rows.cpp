#include "app/tools/sweep/rows.h"

#include <cstddef>
#include <iterator>

#include <fmt/compile.h>

#include "app/files/run_file.h"
#include "app/files/scene_keys.h"

namespace ghostforce {
namespace {

constexpr std::string_view common_columns = "strategy,depth_m";
constexpr std::string_view predicted_columns =
    ",device_x_m,device_y_m,proxy_x_m,proxy_y_m,force_x_N,force_y_N,ghost_force_x_N,ghost_force_y_N,proxy_drift_x_m,"
    "proxy_drift_y_m";
constexpr std::string_view simulated_columns =
    ",simulated_device_x_m,simulated_device_y_m,simulated_proxy_x_m,simulated_proxy_y_m,simulated_force_x_N,"
    "simulated_force_y_N,settled";
constexpr std::string_view not_settled = ",,,,,,,0";

// −0 is a zero too.
void append_vector(fmt::memory_buffer& rows, const Vector<2>& vector) {
  fmt::format_to(std::back_inserter(rows), FMT_COMPILE(",{},{}"), vector.x + 0.0, vector.y + 0.0);
}

}  // namespace

std::string sweep_header(const Scene& scene, const Grid& grid, const EquilibriumKind& kind) {
  std::string header = provenance(scene);
  std::string columns;
  for (const Range& range : grid.ranges) {
    header += fmt::format("# over {}={}:{}:{}{}\n", dotted_name(*range.key), range.values.front(), range.values.back(),
                          range.values.size(), range.logarithmic ? ":log" : "");
    columns += dotted_name(*range.key) + ",";
  }
  return header + fmt::format(
                      "# One row per point and strategy, at rest under the last waypoint. The name of each column ends "
                      "with its unit.\n"
                      "{}{}{}{}\n",
                      columns, common_columns, kind.predicted ? predicted_columns : "",
                      kind.simulated ? simulated_columns : "");
}

void append_sweep_rows(fmt::memory_buffer& rows, const Grid& grid, std::int64_t point, const PointEquilibrium& rest,
                       const EquilibriumKind& kind) {
  // The same in each row of the point, so made once.
  fmt::memory_buffer values;
  for (std::size_t i = 0; i < grid.ranges.size(); ++i) {
    fmt::format_to(std::back_inserter(values), FMT_COMPILE("{},"), value_at(grid, i, point) + 0.0);
  }
  const std::string goal_depth = fmt::format(FMT_COMPILE(",{}"), rest.depth + 0.0);

  for (const Strategy& strategy : strategy_catalog()) {
    rows.append(values);
    rows.append(strategy.name);
    rows.append(goal_depth);
    if (kind.predicted) {
      const PredictedEquilibrium& predicted = rest.predicted[index_of(strategy.id)];
      append_vector(rows, predicted.at.device);
      append_vector(rows, predicted.at.proxy);
      append_vector(rows, predicted.at.force);
      append_vector(rows, predicted.ghost_force);
      append_vector(rows, predicted.proxy_drift);
    }
    if (kind.simulated) {
      if (const auto& simulated = rest.simulated[index_of(strategy.id)]) {
        append_vector(rows, simulated->device);
        append_vector(rows, simulated->proxy);
        append_vector(rows, simulated->force);
        rows.append(std::string_view(",1"));
      } else {
        rows.append(not_settled);
      }
    }
    rows.push_back('\n');
  }
}

}  // namespace ghostforce
