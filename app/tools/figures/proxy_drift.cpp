#include "app/tools/figures/figures.h"

#include <array>
#include <string>

#include "app/files/scene_file.h"
#include "app/tools/figures/sheet.h"
#include "core/conventions.h"
#include "core/ghost_force.h"

namespace ghostforce {
namespace {

constexpr std::string_view drift_scene = "fig3-normal";
constexpr double greatest_ratio_shown = 100.0;
constexpr double greatest_belief = 10.0;

Settings with_belief(Settings settings, double share) {
  settings.stiffnesses.believed_k_u = share * settings.stiffnesses.k_u;
  return settings;
}

double signed_drift(const Settings& settings, const Vector<2>& proxy) {
  const Wall<2> wall = wall_of(settings);
  const Vector<2> goal = goal_behind(wall);
  const Vector<2> along_wall{wall.normal.y, -wall.normal.x};
  const Vector<2> naive = equilibrium_of(StrategyId::naive, settings, goal).proxy;
  const double way = glm::dot(along_wall, naive - goal) > 0.0 ? 1.0 : -1.0;
  return way * mm_per_m * glm::dot(along_wall, proxy_drift(wall, proxy, goal));
}

void add_point(const Settings& settings, std::string_view panel, double x, bool is_simulated, Curves& curves) {
  const StrategyId id = StrategyId::anisotropic;
  const Vector<2> goal = goal_behind(wall_of(settings));
  const Vector<2> proxy = is_simulated ? simulated_equilibrium(settings, goal).strategies[index_of(id)].proxy
                                       : equilibrium_of(id, settings, goal).proxy;
  curves.push_back(
      {std::string(panel), std::string(strategy(id).name), is_simulated, x, signed_drift(settings, proxy)});
}

struct Panel {
  std::string_view name;
  std::string_view axis;
  Settings (*settings_at)(Settings, double);
  double least;
  double greatest;
};
constexpr std::array panels{Panel{over_ratio, "tracking ratio ρ", with_ratio, 1.0, greatest_ratio_shown},
                            Panel{over_belief, "believed over true stiffness of the hand", with_belief,
                                  1.0 / greatest_belief, greatest_belief}};

CsvTable drift_table(const Curves& curves) {
  CsvTable table = table_of(curves, "x", "drift_mm");
  table.comments = {
      "One row per panel and x (the panel's parameter), in closed form, and at some values also simulated.",
      "drift_mm: drift of the proxy along the wall, positive in the direction in which naïve rendering (ρ = 1) drags "
      "it.",
      goal_comment()};
  return table;
}

}  // namespace

Curves proxy_drifts() {
  const Settings settings = load_scene(std::string(drift_scene)).settings;
  Curves curves;
  for (const Panel& panel : panels) {
    for (const double x : evenly_in_ratio(panel.least, panel.greatest, 121)) {
      add_point(panel.settings_at(settings, x), panel.name, x, false, curves);
    }
    for (const double x : evenly_in_ratio(panel.least, panel.greatest, 13)) {
      add_point(panel.settings_at(settings, x), panel.name, x, true, curves);
    }
  }
  return curves;
}

Figure proxy_drift_figure(const FigureRequest&) {
  const Curves curves = proxy_drifts();
  const Stiffnesses k = load_scene(std::string(drift_scene)).settings.stiffnesses;
  Sheet sheet("Proxy drift, over the tracking ratio and over a wrong belief", 860.0);
  sheet.add_row(330.0, panels.size(), [&](const Place& place, std::size_t number) {
    const Panel& panel = panels[number];
    Chart chart;
    chart.x = {
        .title = std::string(panel.axis), .is_logarithmic = true, .range = Vector<2>(panel.least, panel.greatest)};
    chart.y = {.title = "drift along the wall at rest, positive as with naïve rendering [mm]"};
    add_series(curves, panel.name, strategy(StrategyId::anisotropic).name, style_of(StrategyId::anisotropic), chart);
    chart.references = panel.name == over_ratio
                           ? std::vector<Reference>{{optimal_tracking_ratio(k.k_r, k.k_u), true, "optimal: 1 + kᵣ/kᵤ"}}
                           : std::vector<Reference>{{1.0, true, "correct belief"}};
    if (panel.name == over_ratio) {
      Series naive = style_of(StrategyId::naive);
      naive.has_line = false;
      naive.points = {chart.series.front().points.front()};
      chart.series.push_back(naive);
    }
    return chart_on(place, chart);
  });
  std::vector<LegendEntry> legend = strategy_legend();
  legend.erase(legend.begin());
  legend.front().has_line = false;
  legend.front().name += " (ρ = 1)";
  sheet.add_legend(legend);
  return sheet.finish(
      "Wall at 45° to the motor, goal 20 mm inside. Lines: closed form. Points: the simulated loop. The drift vanishes "
      "at the optimal ratio, which needs the true stiffness of the hand. If the belief is too low, the proxy drifts "
      "against the direction of naïve rendering; if it is too high, in that direction.",
      provenance_of_scene(std::string(drift_scene) + ", tracking ratio and believed k_u varied"), drift_table(curves));
}

}  // namespace ghostforce
