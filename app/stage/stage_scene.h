// Where the stage's scene can be taken hold of. Points of the window, y down; pure, any thread.
#pragma once

#include <array>
#include <optional>

#include "app/picture/camera.h"
#include "app/stage/stage_content.h"
#include "app/stage/stage_places.h"
#include "app/state/stage_moment.h"

namespace ghostforce {

// Where the motor's rail and the wall can be taken hold of, in points of the window.
struct StageGrips {
  std::array<Vector<2>, 2> motor;
  std::optional<std::array<Vector<2>, 2>> wall;
};
StageGrips stage_grips(const Settings& settings, const StageMoment& moment, const Camera& camera,
                       const StageLayout& layout, const std::optional<HeldEnd>& held);
inline constexpr double stage_grip_reach = 22.0;  // of the pointer round one [points of the design]

}  // namespace ghostforce
