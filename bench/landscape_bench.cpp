// How long the stage's landscape takes to compose, at the size of the default window: it is made anew for every frame
// in which somebody drags its ring or turns its dial.
#include <cstdint>

#include <benchmark/benchmark.h>

#include "app/files/scene_file.h"
#include "app/paint/vector/vector_painter.h"
#include "app/picture/workspace_layer.h"
#include "app/stage/landscape_contours.h"
#include "app/stage/landscape_layers.h"

namespace ghostforce {
namespace {

void compose_landscape(benchmark::State& state) {
  Settings settings = load_scene("wall45").settings;
  settings.stiffnesses.believed_k_u = 0.3 * settings.stiffnesses.k_u;  // somewhere there is too little
  const MeasureText measure = measure_vector_text;
  const Camera camera{{0.0, 0.0}, 4000.0, {1280.0, 800.0}};
  const LandscapeRoom room{{{800.0, 0.0}, {1280.0, 64.0}}, 680.0};
  const double dial = 0.01 * static_cast<double>(state.range(0));
  Marks marks;
  for (auto _ : state) {
    marks.clear();
    add_landscape({settings, dial, false, english_stage, *find_theme("light"), camera, 1.0, measure, room}, marks);
    benchmark::DoNotOptimize(marks.data());
  }
  state.counters["marks"] = static_cast<double>(marks.size());
}
BENCHMARK(compose_landscape)
    ->Name("landscape/1280x800/dial-percent")
    ->Arg(0)
    ->Arg(50)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond);

void find_contours(benchmark::State& state) {
  const Landscape landscape = landscape_of(load_scene("wall45").settings, 0.0);
  for (auto _ : state) benchmark::DoNotOptimize(contours_of(landscape));
}
BENCHMARK(find_contours)->Name("contours")->Unit(benchmark::kMillisecond);

// Of a device with joints: 160×100 places of its handle.
void map_workspace(benchmark::State& state, const char* scene) {
  const Scene shown = load_scene(scene);
  const WorkspaceMap map = workspace_map(shown.settings, shown.goal.points.back());
  const Camera seen{{-0.15, -0.15}, 240.0, {160.0, 100.0}};
  Marks marks;
  for (auto _ : state) {
    marks.clear();
    add_workspace_cells(map, seen, {Vector<2>(0.0), seen.size}, seen, 1.0, *find_theme("light"), marks);
    benchmark::DoNotOptimize(marks.data());
  }
}
BENCHMARK_CAPTURE(map_workspace, arm, "arm")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(map_workspace, pantograph, "pantograph")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ghostforce
