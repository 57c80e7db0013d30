// SetUp: what stands on the screen and can be handed on: a scene with its settings, where the hand is, which face and
// which mode show it. One line of text holds it all (set_up_line.h): lessons are made of such lines, pictures carry them,
// and people send them to each other. A value; any thread.
#pragma once

#include "app/view/stage/face.h"
#include "app/view/stage/stage_mode.h"
#include "core/scene.h"

namespace ghostforce {

struct SetUp {
  Scene scene;          // as a file would hold it, with the active strategy
  Vector<2> goal{0.0};  // where the hand of a person is [m]
  Face face = Face::stage;
  StageMode mode = StageMode::none;  // of the stage
};

}  // namespace ghostforce
