#include "app/cli/set_up_options.h"

#include <CLI/CLI.hpp>

namespace ghostforce {

void SetUpOptions::attach(CLI::App& command, FileOptions& files) {
  scene.attach(command, files, false);
  command
      .add_option("--goal-mm", goal_mm, "Where your hand starts, at rest, in mm; default: the scene's last waypoint")
      ->type_name("X,Y");
  picture.attach(command, false);
}

SetUp SetUpOptions::set_up(Scene loaded, Face usual) const {
  picture.apply_strategy(loaded);
  if (goal_mm) loaded.goal.points.back() = position_from_mm("--goal-mm", *goal_mm);
  const Vector<2> goal = loaded.goal.points.back();
  return {std::move(loaded), goal, picture.face_or(usual), picture.stage_mode()};
}

}  // namespace ghostforce
