// Saving what is on the screen. Files are written whole or not at all. Throws Failure. UI thread.
#pragma once

#include <string>

#include "app/session/session.h"

namespace ghostforce {

// The scene as it would have to be loaded to show what is seen now: settings as they are, the path's last waypoint
// where the goal is, the view as it is.
Scene scene_as_seen(const Session& session);

void save_scene(const Session& session, const std::string& path);

}  // namespace ghostforce
