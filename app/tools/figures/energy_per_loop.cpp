#include "app/tools/figures/figures.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/files/scene_file.h"
#include "app/tools/figures/curves.h"
#include "app/tools/figures/sheet.h"
#include "core/conventions.h"
#include "core/loop_energy.h"

namespace ghostforce {
namespace {

constexpr std::string_view energy_scene = "wall45";
constexpr double depth_of_center = 0.025;  // the device stays inside all the way round [m]
constexpr double radius = 0.010;           // [m]
constexpr double turns_per_second = 0.1;   // slow enough that the delay of the loop is lost in the width of the line
constexpr double greatest_tracking_ratio = 20.0;

Circle circle_in(const Settings& settings, bool is_counter_clockwise) {
  const Wall<2> wall = wall_of(settings);
  return {.center = wall.point - depth_of_center * wall.normal,
          .radius = radius,
          .turns_per_second = is_counter_clockwise ? turns_per_second : -turns_per_second};
}

// At rest the device is a linear function of the goal: its loop has the circle's area times the function's determinant.
double area_at_equilibrium(const Settings& settings, StrategyId id, const Circle& circle) {
  const auto device = [&](const Vector<2>& goal) { return equilibrium_of(id, settings, goal).device; };
  const Vector<2> origin = device(circle.center);
  const Vector<2> x = device(circle.center + Vector<2>(circle.radius, 0.0)) - origin;
  const Vector<2> y = device(circle.center + Vector<2>(0.0, circle.radius)) - origin;
  const double sense = circle.turns_per_second > 0.0 ? 1.0 : -1.0;
  return sense * std::numbers::pi * (x.x * y.y - x.y * y.x);
}

// The second lap: on the first one the device still comes from where it started.
MeasuredLoop measured_loop(const Settings& settings, StrategyId id, const Circle& circle) {
  const TickCoefficients<2> coefficients = coefficients_of(settings);
  TickState<2> state = state_at_start(position_on(circle, 0.0));
  const auto lap = static_cast<std::int64_t>(std::llround(coefficients.rate / std::abs(circle.turns_per_second)));
  const TickState<2>::StrategyState& now = state.strategies[index_of(id)];
  std::optional<LoopEnergyMeter> meter;
  while (state.tick < 2 * lap) {
    tick(coefficients, position_on(circle, time_of(state.tick + 1, coefficients.rate)), state);
    if (meter) meter->add(now.motion.position, now.energy);
    if (state.tick == lap) meter.emplace(now.motion.position, now.energy);
  }
  return meter->loop();
}

void add_formula(const Settings& settings, StrategyId id, double ratio, bool sense, std::vector<EnergyOfLoop>& loops) {
  const double area = area_at_equilibrium(settings, id, circle_in(settings, sense));
  loops.push_back({id, ratio, sense, false, area, predicted_energy(strategy(id), settings, area)});
}

void add_measured(const Settings& settings, StrategyId id, double ratio, bool sense, std::vector<EnergyOfLoop>& loops) {
  const MeasuredLoop loop = measured_loop(settings, id, circle_in(settings, sense));
  loops.push_back({id, ratio, sense, true, loop.area, loop.energy});
}

}  // namespace

std::vector<EnergyOfLoop> energies_of_loops() {
  const Settings settings = load_scene(std::string(energy_scene)).settings;
  std::vector<EnergyOfLoop> loops;
  for (const bool sense : {false, true}) {
    for (const double ratio : evenly_in_ratio(1.0, greatest_tracking_ratio, 81)) {
      add_formula(with_ratio(settings, ratio), StrategyId::anisotropic, ratio, sense, loops);
    }
    for (const double ratio : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0, 15.0, 20.0}) {
      add_measured(with_ratio(settings, ratio), StrategyId::anisotropic, ratio, sense, loops);
    }
    add_formula(settings, StrategyId::full, 1.0, sense, loops);
    add_measured(settings, StrategyId::full, 1.0, sense, loops);
    add_formula(settings, StrategyId::naive, 1.0, sense, loops);
    add_measured(settings, StrategyId::naive, 1.0, sense, loops);
  }
  return loops;
}

namespace {

constexpr double mj_per_j = 1000.0;

CsvTable table_of(const std::vector<EnergyOfLoop>& loops) {
  CsvTable table;
  table.comments = {
      "One row per strategy, sense and tracking ratio, from the formula, and at some ratios also from the simulation.",
      "energy_J: positive where the rendering gives energy to the hand. device_loop_area_m2: positive "
      "counter-clockwise.",
      fmt::format("circle_center_depth_mm={:g} circle_radius_mm={:g} turns_per_s={:g}: the goal's circle; its centre "
                  "is that deep behind wall.point_mm, along the normal. Simulated rows are from the second lap.",
                  mm_per_m * depth_of_center, mm_per_m * radius, turns_per_second)};
  table.columns = {"series", "sense", "source", "tracking_ratio", "device_loop_area_m2", "energy_J"};
  for (const EnergyOfLoop& loop : loops) {
    table.rows.push_back({std::string(strategy(loop.strategy).name),
                          std::string(loop.is_counter_clockwise ? "counter-clockwise" : "clockwise"),
                          std::string(loop.is_simulated ? "simulated" : "closed form"), loop.ratio, loop.area,
                          loop.energy});
  }
  return table;
}

Series series_of(const std::vector<EnergyOfLoop>& loops, StrategyId id, bool sense, bool is_simulated) {
  Series series = style_of(id);
  series.has_line = !is_simulated;
  if (!is_simulated) series.shape.reset();
  series.is_hollow = sense;
  for (const EnergyOfLoop& loop : loops) {
    if (loop.strategy == id && loop.is_counter_clockwise == sense && loop.is_simulated == is_simulated) {
      series.points.push_back({loop.ratio, mj_per_j * loop.energy});
    }
  }
  return series;
}

}  // namespace

Figure energy_per_loop_figure(const FigureRequest&) {
  const std::vector<EnergyOfLoop> loops = energies_of_loops();
  const Stiffnesses k = load_scene(std::string(energy_scene)).settings.stiffnesses;
  Chart chart;
  chart.x = {.title = "tracking ratio ρ", .is_logarithmic = true, .range = Vector<2>(1.0, greatest_tracking_ratio)};
  chart.y = {.title = "energy given to the hand per loop [mJ]"};
  Series zero = style_of(StrategyId::full);
  zero.shape.reset();
  zero.points = {{1.0, 0.0}, {greatest_tracking_ratio, 0.0}};
  chart.series.push_back(zero);
  for (const bool sense : {false, true}) {
    for (const bool is_simulated : {false, true}) {
      chart.series.push_back(series_of(loops, StrategyId::anisotropic, sense, is_simulated));
    }
  }
  for (const bool sense : {false, true}) {
    for (const StrategyId id : {StrategyId::full, StrategyId::naive}) {
      chart.series.push_back(series_of(loops, id, sense, true));
    }
  }
  chart.references = {{optimal_tracking_ratio(k.k_r, k.k_u), true, "optimal: 1 + kᵣ/kᵤ"}};

  Sheet sheet("Energy per closed loop, over the tracking ratio", 520.0);
  sheet.add_row(340.0, 1, [&](const Place& place, std::size_t) { return chart_on(place, chart); });
  std::vector<LegendEntry> legend = strategy_legend();
  legend[index_of(StrategyId::naive)].has_line = false;
  legend[index_of(StrategyId::naive)].name += " (ρ = 1)";
  for (const auto& [name, is_hollow] :
       {std::pair{"filled: clockwise", false}, std::pair{"hollow: counter-clockwise", true}}) {
    legend.push_back({.name = name, .colour = paper().faint_text, .shape = Shape::disc, .is_hollow = is_hollow});
  }
  sheet.add_legend(legend);
  return sheet.finish(
      "The hand goes slowly round a circle of 10 mm radius inside the wall. Lines: the formula. Points: the simulated "
      "loop. One direction makes energy, the other takes the same amount away. The larger ρ, the less of both.",
      provenance_of_scene(std::string(energy_scene) + ", tracking ratio varied"), table_of(loops));
}

}  // namespace ghostforce
