// Options that the window and the pictures share: which strategy, which theme, how large; which renderer draws
// offscreen; and those that say what the window shows at first.
#pragma once

#include <optional>
#include <string>

#include "app/cli/command.h"
#include "app/shell/desktop/renderer.h"
#include "app/state/session.h"
#include "app/state/set_up.h"
#include "core/scene.h"

namespace ghostforce {

struct PictureOptions {
  std::string strategy;  // empty: the scene's
  std::string theme;     // empty: what was used last, or the first of the catalog
  std::optional<double> scale;
  std::string view;  // empty: as usual
  std::string mode;  // of the stage; empty: none

  // `with_all`: "all" shows every strategy in one picture.
  void attach(CLI::App& command, bool with_all);
  void apply_strategy(Scene& scene) const;
  // A mode belongs to the stage. Throws Failure(wrong_call) where it is asked for on the workbench.
  Face face_or(Face usual) const;
  StageMode stage_mode() const;
  // What was not asked for stays as it is.
  void apply_appearance(Appearance& appearance) const;
};

// --renderer, for commands that draw offscreen; `renderer` stays empty where the option is not given.
void attach_renderer(CLI::App& command, std::optional<Renderer>& renderer);

// The options of `ghostforce run` that say what stands on the screen at first: those that a set-up's line is made of
// (app/state/set_up.h).
struct SetUpOptions {
  SceneOptions scene;
  PictureOptions picture;
  std::optional<std::string> goal_mm;  // empty: the scene's last waypoint

  void attach(CLI::App& command, FileOptions& files);
  // The scene as these options have it; `usual` is the face where none is asked for. Throws Failure(wrong_call).
  SetUp set_up(Scene loaded, Face usual) const;
};

}  // namespace ghostforce
