#include "app/tools/figures/curves.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/tools/figures/sheet.h"
#include "core/conventions.h"
#include "core/divergence.h"
#include "core/simulate.h"

namespace ghostforce {
namespace {

constexpr double outside = 0.010;  // where the way begins, before the wall [m]
constexpr double way_s = 0.5;
constexpr double until_s = 4.0;

}  // namespace

CsvTable table_of(const Curves& curves, const std::string& x_name, const std::string& y_name) {
  CsvTable table;
  table.columns = {"panel", "series", "source", x_name, y_name};
  for (const CurvePoint& point : curves) {
    table.rows.push_back(
        {point.panel, point.series, std::string(point.is_simulated ? "simulated" : "closed form"), point.x, point.y});
  }
  return table;
}

Vector<2> goal_behind(const Wall<2>& wall) {
  return wall.point - curve_goal_depth * wall.normal;
}

std::string goal_comment() {
  return fmt::format(
      "goal_depth_mm={:g}: the goal is that deep behind wall.point_mm, along the normal. In the simulation, it comes "
      "from {:g} mm outside in {:g} s by minimum jerk, and the row is at {:g} s.",
      mm_per_m * curve_goal_depth, mm_per_m * outside, way_s, until_s);
}

void add_series(const Curves& curves, std::string_view panel, std::string_view series, const Series& style,
                Chart& chart) {
  Series curve = style;
  curve.shape.reset();
  Series points = style;
  points.name.clear();
  points.has_line = false;
  for (const CurvePoint& point : curves) {
    if (point.panel != panel || point.series != series) continue;
    (point.is_simulated ? points : curve).points.push_back({point.x, point.y});
  }
  chart.series.push_back(std::move(curve));
  chart.series.push_back(std::move(points));
}

Settings with_ratio(Settings settings, double ratio) {
  settings.stiffnesses.chosen_tracking_ratio = ratio;
  return settings;
}

Series style_of(StrategyId id) {
  constexpr PerStrategy<double> widths = std::to_array({3.2, 2.2, 1.8});
  return {.name = "",
          .colour = paper().strategy[index_of(id)],
          .points = {},
          .pattern = strategy_style(id).pattern,
          .width = widths[index_of(id)],
          .shape = strategy_style(id).shape};
}

std::vector<double> evenly(double least, double greatest, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(least + (greatest - least) * i / (count - 1));
  return values;
}

std::vector<double> evenly_in_ratio(double least, double greatest, int count) {
  std::vector<double> values;
  for (const double exponent : evenly(std::log10(least), std::log10(greatest), count)) {
    values.push_back(std::pow(10.0, exponent));
  }
  values.front() = least;  // not less by rounding
  values.back() = greatest;
  return values;
}

Snapshot simulated_equilibrium(const Settings& settings, const Vector<2>& goal) {
  const Wall<2> wall = wall_of(settings);
  Scene scene;
  scene.settings = settings;
  scene.goal = {.points = {projection(wall, goal) + outside * wall.normal, goal},
                .times = {0.0, way_s},
                .motion = Motion::minimum_jerk};
  scene.duration = until_s;
  Snapshot rest;
  const TickState<2> state = simulate(scene, last_tick(scene), [&](const Snapshot& snapshot) { rest = snapshot; });
  if (!has_diverged(state)) return rest;
  throw Failure(ExitCode::bug, "a figure's sampled loop is unstable; its settings in app/tools/figures are at fault");
}

}  // namespace ghostforce
