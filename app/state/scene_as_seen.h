// Saving what is on the screen. UI thread.
#pragma once

#include "app/state/session.h"

namespace ghostforce {

// The scene as it would have to be loaded to show what is seen now: settings as they are, the path's last waypoint
// where the goal is, the view as it is.
Scene scene_as_seen(const Session& session);

}  // namespace ghostforce
