#include "app/tools/figures/curves.h"

#include <string>

#include <fmt/format.h>

#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

double along_motor(const Settings& settings, const Vector<2>& force) {
  const Vector<2> axis = direction_at(settings.actuated_angle);
  const bool points_away = glm::dot(axis, wall_of(settings).normal) > 0.0;
  return glm::dot(points_away ? axis : -axis, force) + 0.0;  // −0 is a zero too
}

}  // namespace

void add_closed_forms(const Settings& settings, double x, Curves& curves) {
  const Wall<2> wall = wall_of(settings);
  const Actuation<2> actuation = actuation_of(settings);
  const Vector<2> goal = goal_behind(wall);
  const PerStrategy<Equilibrium<2>> rest = std::to_array<Equilibrium<2>>({
      equilibrium_fully_actuated(wall, settings.stiffnesses, goal),
      equilibrium_naive(wall, actuation, settings.stiffnesses, goal),
      equilibrium_anisotropic(wall, actuation, settings.stiffnesses, goal),
  });
  for (const Strategy& strategy : strategy_catalog()) {
    curves.push_back(
        {"", std::string(strategy.name), false, x, along_motor(settings, rest[index_of(strategy.id)].force)});
  }
}

void add_simulated(const Settings& settings, StrategyId id, double x, Curves& curves) {
  const Snapshot rest = simulated_equilibrium(settings, goal_behind(wall_of(settings)));
  curves.push_back(
      {"", std::string(strategy(id).name), true, x, along_motor(settings, rest.strategies[index_of(id)].force)});
}

CsvTable force_table(const Curves& curves, const std::string& x_name) {
  CsvTable table = table_of(curves, x_name, "force_N");
  table.comments = {
      fmt::format("One row per strategy and {}, in closed form, and at some values also simulated.", x_name),
      "force_N: the force of the device on the hand along the actuated direction, positive away from the wall. The "
      "motor then pushes to the left, so this is −force_x_N of the other figures.",
      goal_comment()};
  return table;
}

void add_force_chart(const Curves& curves, const Axis& x, Sheet& sheet) {
  Chart chart;
  chart.x = x;
  chart.y = {.title = "force along the actuated direction at rest, away from the wall [N]"};
  for (const Strategy& strategy : strategy_catalog()) {
    add_series(curves, "", strategy.name, style_of(strategy.id), chart);
  }
  sheet.add_row(340.0, 1, [&](const Place& place, std::size_t) { return chart_on(place, chart); });
  sheet.add_legend(strategy_legend());
}

}  // namespace ghostforce
