#include "app/session/scene_as_seen.h"

#include "app/files/output_file.h"
#include "app/files/scene_file.h"

namespace ghostforce {

Scene scene_as_seen(const Session& session) {
  Scene scene = *session.scene;
  scene.settings = session.settings;
  scene.view = session.shown;
  if (session.pointer_moves_goal) scene.goal.points.back() = session.goal;
  return rounded_to_file(std::move(scene));
}

void save_scene(const Session& session, const std::string& path) {
  OutputFile file(path);
  file.write(scene_text(scene_as_seen(session)));
  file.commit();
}

}  // namespace ghostforce
