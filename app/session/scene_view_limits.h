// What part of the world a person may look at: as much as a scene's file can hold. Pure, any thread.
#pragma once

#include "core/scene.h"

namespace ghostforce {

// The nearest view that a scene's file can hold.
SceneView within_scene_limits(SceneView shown);

// Zooms by `factor` (above 1: closer), so that the world point `at` stays where it is.
SceneView zoomed(const SceneView& shown, double factor, const Vector<2>& at);

}  // namespace ghostforce
