// Base or elbow? Over the workspace of an arm, how strong the ghost force of naïve rendering is at a wall of one
// direction, for either place of the motor.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "app/files/scene_file.h"
#include "app/picture/workspace_layer.h"
#include "app/tools/figures/figures.h"
#include "app/tools/figures/sheet.h"
#include "core/conventions.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr const char* scene_name = "arm";
constexpr double pane_height = 410.0;

struct MotorPlace {
  std::string name;
  Settings settings;
};

std::array<MotorPlace, 2> motor_places() {
  Settings settings = load_scene(scene_name).settings;
  settings.active = StrategyId::naive;
  return {MotorPlace{"motor at the base", settings}, MotorPlace{"motor at the elbow", with_other_motor(settings)}};
}

Vector<2> goal_of_scene() {
  return load_scene(scene_name).goal.points.back();
}

std::string_view word_for(WallAtPose::Rest rest) {
  return rest == WallAtPose::Rest::stays ? "yes" : "no";
}

}  // namespace

std::vector<WallOfMotor> walls_of_motors() {
  constexpr double step_m = 0.01;
  std::vector<WallOfMotor> walls;
  for (const MotorPlace& place : motor_places()) {
    const WorkspaceMap map = workspace_map(place.settings, goal_of_scene());
    const TwoLinkArm& arm = place.settings.general.arm;
    const double reach = arm.links[0] + arm.links[1];
    const int steps = static_cast<int>(std::ceil(reach / step_m));
    for (int row = -steps; row <= steps; ++row) {
      for (int column = -steps; column <= steps; ++column) {
        const Vector<2> handle = arm.base + step_m * Vector<2>(column, row);
        const WallAtPose found = map.at(handle);
        if (found.rest != WallAtPose::Rest::unreachable) walls.push_back({place.name, handle, found});
      }
    }
  }
  return walls;
}

Figure which_walls_figure(const FigureRequest&) {
  CsvTable table;
  table.comments = {
      "One row per motor and place of the handle at rest, with the wall's direction and the hand's depth of the scene.",
      "ghost_share: ghost force of naïve rendering over the push that the wall should give. rests: whether the handle "
      "stays there.",
      "motor_deg: the direction in which the motor pushes the handle."};
  table.columns = {"motor", "x_mm", "y_mm", "rests", "ghost_share", "motor_deg"};
  for (const WallOfMotor& wall : walls_of_motors()) {
    table.rows.push_back({wall.motor, wall.handle.x * mm_per_m, wall.handle.y * mm_per_m,
                          std::string(word_for(wall.found.rest)), wall.found.ghost_share,
                          std::atan2(wall.found.motor.y, wall.found.motor.x) * degrees_per_radian});
  }
  Sheet sheet("Which walls are bad for an arm with one motor?", 900.0);
  const std::array<MotorPlace, 2> places = motor_places();
  sheet.add_titles(std::array{places[0].name, places[1].name});
  sheet.add_row(pane_height, places.size(), [&](const Place& place, std::size_t i) {
    const Settings& settings = places[i].settings;
    const TwoLinkArm& arm = settings.general.arm;
    constexpr double margin = 12.0;
    const double reach = arm.links[0] + arm.links[1];
    const double points_per_metre = (0.5 * std::min(place.size.x, place.size.y) - margin) / reach;
    Pane pane{place.corner, Camera{arm.base, points_per_metre, place.size}, StrategyId::naive, {}};
    const WorkspaceMap map = workspace_map(settings, goal_of_scene());
    const ScreenBox box{Vector<2>(0.0), place.size};
    add_workspace_cells(map, pane.camera, box, pane.camera, 3.0, paper(), pane.marks);
    add_workspace_strokes(map, pane.camera, box, 0.6, paper(), pane.marks);
    const Vector<2>& middle = arm.base;
    const Vector<2> along(-map.normal.y, map.normal.x);
    pane.marks.push_back(
        {Role::wall, {}, Line{middle - reach * along, middle + reach * along, 2.5, paper().wall_edge}});
    pane.marks.push_back(
        {Role::joint, {}, Marker{middle, Shape::disc, 5.0, paper().wall_edge, paper().wall_edge, 0.0}});
    return pane;
  });
  return sheet.finish(
      "Each place is one of the handle at rest, at a wall as the line through the base has it. Red: the ghost force of "
      "naïve rendering, deepest at three times the push that the wall should give; striped: the handle runs away. "
      "Strokes: the line that the motor pushes along. Grey: out of reach.",
      provenance_of_scene(std::string(scene_name) + ", either motor"), std::move(table));
}

}  // namespace ghostforce
