// The map of a device with joints: which of the walls of one direction are bad, wherever the handle is. On the stage and
// in figures. Pure, any thread.
#pragma once

#include "app/picture/camera.h"
#include "app/picture/marks.h"
#include "app/picture/screen_box.h"
#include "app/picture/theme.h"
#include "core/workspace_map.h"

namespace ghostforce {

// What all places of a map have in common.
struct WorkspaceMap {
  GeneralScene scene;
  StrategyId id;
  Vector<2> normal;  // of the walls, outward
  double depth;      // of the hand in them [m]

  WallAtPose at(const Vector<2>& handle) const noexcept { return wall_at_pose(scene, id, handle, normal, depth); }
  // With these motors and this renderer no wall is bad.
  bool is_without_ghost() const noexcept;
};

// At the wall that is nearest to the hand. A hand in front of it is taken for one that is a little behind it.
WorkspaceMap workspace_map(const Settings& settings, const Vector<2>& goal) noexcept;

// In a box of the picture, whose camera is `camera`: the ghost force of each place as seen by `seen`, in cells with sides
// of `side` [points].
void add_workspace_cells(const WorkspaceMap& map, const Camera& camera, const ScreenBox& box, const Camera& seen,
                         double side, const Theme& theme, Marks& marks);

// The line that the motor pushes along, and stripes where the handle runs away. `unit`: a point of the design.
void add_workspace_strokes(const WorkspaceMap& map, const Camera& camera, const ScreenBox& box, double unit,
                           const Theme& theme, Marks& marks);

}  // namespace ghostforce
