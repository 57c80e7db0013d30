// What part of the world a person may look at: as much as a scene's file can hold. Pure, any thread.
#pragma once

#include "app/picture/pane_views.h"
#include "app/state/session.h"
#include "core/scene.h"

namespace ghostforce {

// The nearest view that a scene's file can hold.
SceneView within_scene_limits(SceneView shown);

// Zooms by `factor` (above 1: closer), so that the world point `at` stays where it is.
SceneView zoomed(const SceneView& shown, double factor, const Vector<2>& at);

// The same of panes side by side: where the pointer is in one, all the others do likewise. `at`: in that pane.
PaneViews zoomed(const PaneViews& views, double factor, StrategyId pane, const Vector<2>& at);
PaneViews moved(const PaneViews& views, const Vector<2>& by);

// Saving what is on the screen. UI thread.

// The scene as it would have to be loaded to show what is seen now: settings as they are, the path's last waypoint
// where the goal is, the view as it is.
Scene scene_as_seen(const Session& session);

}  // namespace ghostforce
