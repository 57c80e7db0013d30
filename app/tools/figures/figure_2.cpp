#include "app/tools/figures/figures.h"

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "app/files/scene_file.h"
#include "app/tools/figures/scene_pane.h"

namespace ghostforce {
namespace {

constexpr std::string_view figure_2_scene = "fig3-normal";
// Softer than in the other figures, so that proxy and contact are seen apart.
const std::array<std::string, 3> softer{"rendering.k_r_N_per_m=200", "rendering.k_t_N_per_m=300",
                                        "rendering.k_c_N_per_m=1000"};

ScenePicture picture_of(const ThreeEquilibria& data, const Strategy& strategy) {
  const std::size_t i = index_of(strategy.id);
  const Equilibrium<2>& rest = data.rest[i].at;
  const Colour colour = paper().strategy[i];
  ScenePicture picture{.title = fmt::format("{}  {}", strategy.letter, strategy.title),
                       .settings = data.scene.settings};
  picture.settings.active = strategy.id;
  // Where the proxy would be without drift.
  picture.trails.push_back({{rest.goal, projection(wall_of(data.scene.settings), rest.goal)},
                            mix(paper().wall, paper().faint_text, 0.35),
                            solid_line,
                            1.0});
  // What pulls at what: the hand at the device, the device at the proxy, the wall at the proxy.
  picture.trails.push_back({{rest.goal, rest.device}, paper().faint_text, dotted_line, 1.8});
  picture.trails.push_back({{rest.device, rest.proxy}, colour, solid_line, 1.8});
  picture.trails.push_back({{rest.proxy, rest.contact}, paper().wall_edge, {4.0, 3.0, 4.0, 3.0}, 1.6});
  picture.points.push_back({.at = rest.contact,
                            .fill = paper().wall_edge,
                            .rim = paper().wall_edge,
                            .radius = 2.6,
                            .name = "q",
                            .subscript = "c"});
  picture.points.push_back({.at = rest.proxy,
                            .shape = strategy_style(strategy.id).shape,
                            .fill = paper().background,
                            .rim = colour,
                            .radius = 6.0,
                            .name = "q",
                            .subscript = "p"});
  picture.points.push_back(device_point(strategy.id, rest.device, "q", "h"));
  picture.points.push_back(goal_point(rest.goal, "q", "u"));
  return picture;
}

}  // namespace

ThreeEquilibria three_equilibria() {
  ThreeEquilibria data{.scene = load_scene(std::string(figure_2_scene), softer)};
  data.rest = predicted_equilibria(data.scene.settings, data.scene.goal.points.back());
  return data;
}

CsvTable table_of(const ThreeEquilibria& data) {
  CsvTable table;
  table.comments = {"One row per strategy, in closed form. Units: m, N."};
  table.columns = {"strategy",  "goal_x_m",        "goal_y_m",       "device_x_m",  "device_y_m",
                   "proxy_x_m", "proxy_y_m",       "contact_x_m",    "contact_y_m", "force_x_N",
                   "force_y_N", "proxy_drift_x_m", "proxy_drift_y_m"};
  for (const Strategy& strategy : strategy_catalog()) {
    const auto& [rest, ghost_force, drift] = data.rest[index_of(strategy.id)];
    table.rows.push_back({std::string(strategy.name), rest.goal.x, rest.goal.y, rest.device.x, rest.device.y,
                          rest.proxy.x, rest.proxy.y, rest.contact.x, rest.contact.y, rest.force.x, rest.force.y,
                          drift.x, drift.y});
  }
  return table;
}

Figure three_equilibria_figure(const FigureRequest&) {
  const ThreeEquilibria data = three_equilibria();
  Sheet sheet("The three equilibria", 860.0);
  std::vector<ScenePicture> pictures;
  for (const Strategy& strategy : strategy_catalog()) pictures.push_back(picture_of(data, strategy));
  add_scenes(sheet, 270.0, std::move(pictures), strategy_count);
  sheet.add_legend(
      {{.name = "hand's spring, kᵤ", .colour = paper().faint_text, .has_line = true, .pattern = dotted_line},
       {.name = "rendering and tracking, Kᵣ and Kₜ", .colour = paper().text, .has_line = true},
       {.name = "wall's spring", .colour = paper().wall_edge, .has_line = true, .pattern = {4.0, 3.0, 4.0, 3.0}}});
  std::string scene(figure_2_scene);
  for (const std::string& value : softer) scene += " --set " + value;
  return sheet.finish(
      "The same hand with its goal qᵤ, at rest: device qₕ, proxy qₚ, and its contact on the wall. Without drift, the "
      "proxy lies on the thin line from qᵤ normal to the wall, as it does for F and A. With naïve rendering, it has "
      "drifted along the wall and drags the device with it.",
      provenance_of_scene(scene), table_of(data));
}

}  // namespace ghostforce
