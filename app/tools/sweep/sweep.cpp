#include "app/tools/sweep/sweep.h"

#include <algorithm>
#include <iterator>
#include <thread>
#include <vector>

#include <fmt/compile.h>

#include "app/base/interruption.h"
#include "app/files/run.h"
#include "app/files/scene_keys.h"
#include "app/tools/sweep/ordered_parallel_for.h"
#include "core/general_tick.h"

namespace ghostforce {
namespace {

// Points of a block: enough that handing it over costs nothing beside it, few enough that the progress shows and that
// the blocks in memory stay small (a row by closed form has some 250 letters; points that never come to rest take some
// 2 ms each). Of simulated points there are enough for vectors to be full while the slowest ones come to rest.
constexpr std::int64_t predicted_per_block = 512;
constexpr std::int64_t simulated_per_block = 32;

struct Block {
  fmt::memory_buffer rows;
  std::int64_t points = 0;
  std::int64_t unsettled = 0;
  bool is_whole = true;
  std::chrono::nanoseconds computing{0};
  std::chrono::nanoseconds formatting{0};
};

Block make_block(const SweepPlan& plan, std::int64_t first, std::int64_t count) {
  using Clock = std::chrono::steady_clock;
  Block block;
  Scene scene = plan.scene;
  PointEquilibria points(plan.kind, static_cast<std::size_t>(count), has_general_points(plan.scene, plan.grid));
  const Clock::time_point start = Clock::now();
  while (block.points < count && !interrupted()) {
    put_point(plan.grid, first + block.points, scene);
    points.add(scene);
    ++block.points;
  }
  const std::vector<PointEquilibrium> equilibria = points.take(scene.goal);
  const Clock::time_point computed = Clock::now();
  for (std::int64_t i = 0; i < block.points; ++i) {
    const PointEquilibrium& rest = equilibria[static_cast<std::size_t>(i)];
    append_sweep_rows(block.rows, plan.grid, first + i, rest, plan.kind);
    if (plan.kind.simulated)
      block.unsettled += std::ranges::count(rest.simulated, false, &std::optional<SimulatedEquilibrium>::has_value);
  }
  block.is_whole = block.points == count;
  block.computing = computed - start;
  block.formatting = Clock::now() - computed;
  return block;
}

}  // namespace

std::size_t sweep_threads() noexcept {
  return std::max(1U, std::thread::hardware_concurrency());
}

bool sweep(const SweepPlan& plan, std::size_t thread_count, const std::function<void(const SweptBlock&)>& take) {
  const std::int64_t points = size_of(plan.grid);
  const std::int64_t per_block = plan.kind.simulated ? simulated_per_block : predicted_per_block;
  std::int64_t swept = 0;
  OrderedParallelFor<Block>::run(
      (points + per_block - 1) / per_block, thread_count,
      [&](std::int64_t i) {
        const std::int64_t first = i * per_block;
        return make_block(plan, first, std::min(per_block, points - first));
      },
      [&](Block&& block) {
        swept += block.points;
        take({{block.rows.data(), block.rows.size()}, swept, block.unsettled, block.computing, block.formatting});
        return block.is_whole && !interrupted();
      });
  return swept == points;
}

namespace {

constexpr std::string_view common_columns = "strategy,depth_m";
constexpr std::string_view predicted_columns =
    ",device_x_m,device_y_m,proxy_x_m,proxy_y_m,force_x_N,force_y_N,ghost_force_x_N,ghost_force_y_N,proxy_drift_x_m,"
    "proxy_drift_y_m";
constexpr std::string_view simulated_columns =
    ",simulated_device_x_m,simulated_device_y_m,simulated_proxy_x_m,simulated_proxy_y_m,simulated_force_x_N,"
    "simulated_force_y_N,settled";
constexpr std::string_view not_settled = ",,,,,,,0";
constexpr std::string_view no_rest = ",,,,,,,,,,";

// What a general scene adds: whether there is a rest, and the motors' efforts, predicted and simulated.
std::string general_columns(const Scene& scene, const Grid& grid, const EquilibriumKind& kind) {
  std::string columns;
  if (!has_general_points(scene, grid)) return columns;
  const std::size_t motors = motor_count(mechanism_of(scene.settings));
  const auto add_efforts = [&](std::string_view prefix) {
    for (std::size_t i = 1; i <= motors; ++i) columns += fmt::format(",{}effort_{}", prefix, i);
  };
  if (kind.predicted) {
    columns += ",rests";
    add_efforts("");
  }
  if (kind.simulated) add_efforts("simulated_");
  return columns;
}

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
                      "{}{}{}{}{}\n",
                      columns, common_columns, kind.predicted ? predicted_columns : "",
                      kind.simulated ? simulated_columns : "", general_columns(scene, grid, kind));
}

namespace {

void append_predicted(fmt::memory_buffer& rows, const Equilibrium<2>& at, const Vector<2>& ghost_force,
                      const Vector<2>& proxy_drift) {
  append_vector(rows, at.device);
  append_vector(rows, at.proxy);
  append_vector(rows, at.force);
  append_vector(rows, ghost_force);
  append_vector(rows, proxy_drift);
}

// Empty where there are none.
void append_efforts(fmt::memory_buffer& rows, const Efforts* efforts, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (efforts == nullptr) {
      rows.push_back(',');
    } else {
      fmt::format_to(std::back_inserter(rows), FMT_COMPILE(",{}"), (*efforts)[i] + 0.0);
    }
  }
}

}  // namespace

void append_sweep_rows(fmt::memory_buffer& rows, const Grid& grid, std::int64_t point, const PointEquilibrium& rest,
                       const EquilibriumKind& kind) {
  // The same in each row of the point, so made once.
  fmt::memory_buffer values;
  for (std::size_t i = 0; i < grid.ranges.size(); ++i) {
    fmt::format_to(std::back_inserter(values), FMT_COMPILE("{},"), value_at(grid, i, point) + 0.0);
  }
  const std::string goal_depth = fmt::format(FMT_COMPILE(",{}"), rest.depth + 0.0);

  for (const Strategy& strategy : strategy_catalog()) {
    const auto& general = rest.general[index_of(strategy.id)];
    const auto& simulated = rest.simulated[index_of(strategy.id)];
    rows.append(values);
    rows.append(strategy.name);
    rows.append(goal_depth);
    if (kind.predicted && !rest.is_general) {
      const PredictedEquilibrium& predicted = rest.predicted[index_of(strategy.id)];
      append_predicted(rows, predicted.at, predicted.ghost_force, predicted.proxy_drift);
    } else if (kind.predicted && general) {
      append_predicted(rows, general->rest.at, general->ghost_force, general->slide);
    } else if (kind.predicted) {
      rows.append(no_rest);
    }
    if (kind.simulated) {
      if (simulated) {
        append_vector(rows, simulated->device);
        append_vector(rows, simulated->proxy);
        append_vector(rows, simulated->force);
        rows.append(std::string_view(",1"));
      } else {
        rows.append(not_settled);
      }
    }
    if (rest.is_general && kind.predicted) {
      rows.append(std::string_view(general ? ",1" : ",0"));
      append_efforts(rows, general ? &general->rest.efforts : nullptr, rest.motors);
    }
    if (rest.is_general && kind.simulated) append_efforts(rows, simulated ? &simulated->efforts : nullptr, rest.motors);
    rows.push_back('\n');
  }
}

}  // namespace ghostforce
