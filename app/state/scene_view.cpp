#include "app/state/scene_view.h"

#include "app/files/scene_file.h"

namespace ghostforce {

SceneView zoomed(const SceneView& shown, double factor, const Vector<2>& at) {
  const double width = within_scene_limits({shown.center, shown.width / factor}).width;
  return within_scene_limits({at + (shown.center - at) * (width / shown.width), width});
}

PaneViews zoomed(const PaneViews& views, double factor, StrategyId pane, const Vector<2>& at) {
  const SceneView before{views.centers[index_of(pane)], views.width};
  const SceneView after = zoomed(before, factor, at);
  PaneViews result = moved(views, after.center - before.center);
  result.width = after.width;
  return result;
}

PaneViews moved(const PaneViews& views, const Vector<2>& by) {
  PaneViews result = views;
  for (Vector<2>& center : result.centers) center = nearest_in_scene(center + by);
  return result;
}

Scene scene_as_seen(const Session& session) {
  Scene scene = *session.scene;
  scene.settings = session.settings;
  scene.view = session.shown;
  if (session.pointer_moves_goal) scene.goal.points.back() = session.goal;
  return rounded_to_file(std::move(scene));
}

}  // namespace ghostforce
