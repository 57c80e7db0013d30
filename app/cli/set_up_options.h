// The options of `ghostforce run` that say what stands on the screen at first: those that a set-up's line is made of
// (app/state/set_up_line.h).
#pragma once

#include <optional>
#include <string>

#include "app/cli/command.h"
#include "app/cli/picture_options.h"
#include "app/state/set_up.h"

namespace ghostforce {

struct SetUpOptions {
  SceneOptions scene;
  PictureOptions picture;
  std::optional<std::string> goal_mm;  // empty: the scene's last waypoint

  void attach(CLI::App& command, FileOptions& files);
  // The scene as these options have it; `usual` is the face where none is asked for. Throws Failure(wrong_call).
  SetUp set_up(Scene loaded, Face usual) const;
};

}  // namespace ghostforce
