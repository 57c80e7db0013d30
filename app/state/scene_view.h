// What part of the world a person may look at, which is as much as a scene's file can hold; and the scene as it would
// be saved with that view. Pure, any thread.
#pragma once

#include "app/picture/pane_views.h"
#include "app/state/session.h"
#include "core/scene.h"

namespace ghostforce {

// Zooms by `factor` (above 1: closer), so that the world point `at` stays where it is.
SceneView zoomed(const SceneView& shown, double factor, const Vector<2>& at);

// Panes side by side are zoomed and moved together. `at`: under the pointer, in the pane that it is in.
PaneViews zoomed(const PaneViews& views, double factor, StrategyId pane, const Vector<2>& at);
PaneViews moved(const PaneViews& views, const Vector<2>& by);

// The scene as it would have to be loaded to show what is seen now: settings as they are, the path's last waypoint
// where the goal is, the view as it is.
Scene scene_as_seen(const Session& session);

}  // namespace ghostforce
