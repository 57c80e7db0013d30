#include "app/tools/sweep/sweep.h"

#include <algorithm>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "app/base/interruption.h"
#include "app/tools/sweep/ordered_parallel_for.h"
#include "app/tools/sweep/rows.h"

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
  bool is_whole = true;
  std::chrono::nanoseconds computing{0};
  std::chrono::nanoseconds formatting{0};
};

Block make_block(const SweepPlan& plan, std::int64_t first, std::int64_t count) {
  using Clock = std::chrono::steady_clock;
  Block block;
  Scene scene = plan.scene;
  PointEquilibria points(plan.kind, static_cast<std::size_t>(count));
  const Clock::time_point start = Clock::now();
  while (block.points < count && !interrupted()) {
    put_point(plan.grid, first + block.points, scene);
    points.add(scene);
    ++block.points;
  }
  const std::vector<PointEquilibrium> equilibria = points.take(scene.goal);
  const Clock::time_point computed = Clock::now();
  for (std::int64_t i = 0; i < block.points; ++i) {
    append_sweep_rows(block.rows, plan.grid, first + i, equilibria[static_cast<std::size_t>(i)], plan.kind);
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
        take({{block.rows.data(), block.rows.size()}, swept, block.computing, block.formatting});
        return block.is_whole && !interrupted();
      });
  return swept == points;
}

}  // namespace ghostforce
