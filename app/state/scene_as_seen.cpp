#include "app/state/scene_as_seen.h"

#include "app/files/scene_file.h"

namespace ghostforce {

Scene scene_as_seen(const Session& session) {
  Scene scene = *session.scene;
  scene.settings = session.settings;
  scene.view = session.shown;
  if (session.pointer_moves_goal) scene.goal.points.back() = session.goal;
  return rounded_to_file(std::move(scene));
}

}  // namespace ghostforce
