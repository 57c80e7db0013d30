// How long a sweep takes, writing it out not counted.
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "app/files/scene_file.h"
#include "app/tools/sweep/point_equilibrium.h"
#include "app/tools/sweep/sweep.h"

namespace ghostforce {
namespace {

void sweep_by_closed_form(benchmark::State& state) {
  const auto thread_count = static_cast<std::size_t>(state.range(0));
  const Scene scene = load_scene("fig3-normal");
  const Grid grid = make_grid(
      std::vector<std::string>{"wall.normal_deg=90:180:1000", "rendering.k_r_N_per_m=100:1e4:1000:log"}, scene);
  std::chrono::nanoseconds computing{0};
  std::chrono::nanoseconds formatting{0};
  for (auto _ : state) {
    std::size_t letters = 0;
    sweep({scene, grid, equilibrium_kinds.front()}, thread_count, [&](const SweptBlock& block) {
      letters += block.rows.size();
      computing += block.computing;
      formatting += block.formatting;
    });
    benchmark::DoNotOptimize(letters);
  }
  const auto share = [&](std::chrono::nanoseconds all_threads) {
    return benchmark::Counter(std::chrono::duration<double>(all_threads).count() / static_cast<double>(thread_count),
                              benchmark::Counter::kAvgIterations);
  };
  state.counters["computing_s"] = share(computing);
  state.counters["text_s"] = share(formatting);
}
BENCHMARK(sweep_by_closed_form)
    ->Name("sweep/1000x1000/closed-form")
    ->Arg(1)
    ->Arg(static_cast<std::int64_t>(sweep_threads()))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void simulate_one_point_to_equilibrium(benchmark::State& state) {
  const Scene scene = load_scene("fig3-normal");
  const SimulatedPoint point{scene.settings, scene.duration};
  for (auto _ : state) {
    const auto equilibria = simulate_to_equilibrium(scene.goal, {&point, 1});
    benchmark::DoNotOptimize(equilibria);
  }
}
BENCHMARK(simulate_one_point_to_equilibrium)->Name("settle/fig3-normal")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ghostforce
