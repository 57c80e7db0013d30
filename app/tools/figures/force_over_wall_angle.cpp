#include "app/tools/figures/figures.h"

#include <numbers>
#include <string_view>

#include "app/files/scene_file.h"
#include "app/tools/figures/curves.h"

namespace ghostforce {
namespace {

constexpr std::string_view wall_angle_scene = "fig3-normal";

Settings settings_at_wall_angle(Settings settings, double angle_deg) {
  // The motor pushes to the left, away from a wall at the right.
  settings.wall_normal_angle = std::numbers::pi - angle_deg * std::numbers::pi / 180.0;
  return settings;
}

}  // namespace

Curves force_over_wall_angle() {
  const Settings settings = load_scene(std::string(wall_angle_scene)).settings;
  Curves curves;
  for (const double angle : evenly(0.0, 90.0, 181)) {
    add_closed_forms(settings_at_wall_angle(settings, angle), angle, curves);
  }
  // F and A lie on one curve: they are simulated at angles of their own, so that both are seen.
  for (const double angle : evenly(0.0, 90.0, 10)) {
    for (const StrategyId id : {StrategyId::full, StrategyId::naive}) {
      add_simulated(settings_at_wall_angle(settings, angle), id, angle, curves);
    }
  }
  for (const double angle : evenly(5.0, 85.0, 9)) {
    add_simulated(settings_at_wall_angle(settings, angle), StrategyId::anisotropic, angle, curves);
  }
  return curves;
}

Figure force_over_wall_angle_figure(const FigureRequest&) {
  const Curves curves = force_over_wall_angle();
  Sheet sheet("Force along the actuated direction, over the wall's angle", 520.0);
  add_force_chart(
      curves, {.title = "angle between wall normal and actuated direction [°]", .range = Vector<2>(0.0, 90.0)}, sheet);
  return sheet.finish(
      "Goal 20 mm inside the wall. Lines: equations (11), (15) and (20). Points: the simulated loop. A lies on F at "
      "every angle. The excess of N over them is the ghost force.",
      provenance_of_scene(std::string(wall_angle_scene) + ", wall turned"), force_table(curves, "wall_angle_deg"));
}

}  // namespace ghostforce
