// SetUp: what stands on the screen and can be handed on: a scene with its settings, where the hand is, which face and
// which mode show it. One line of text holds it all (set_up_line.h): lessons are made of such lines, pictures carry them,
// and people send them to each other. A value; any thread.
#pragma once

#include "app/state/face.h"
#include "app/state/stage_mode.h"
#include "core/scene.h"

namespace ghostforce {

// The path of the scene ends where the hand is, as `run --goal-mm` and a saved scene have it: a reset brings the hand
// back to that place.
struct SetUp {
  Scene scene;          // as a file would hold it, with the active strategy; its path ends at `goal`
  Vector<2> goal{0.0};  // where the hand of a person is [m]
  Face face = Face::stage;
  StageMode mode = StageMode::none;  // of the stage; on the workbench none
};

}  // namespace ghostforce
