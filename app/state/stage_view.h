// How much of the world the stage shows, and how long its arrows are. Pure, any thread.
#pragma once

#include <span>

#include "core/scene.h"

namespace ghostforce {

// The part of the world with hand, wall, and where all strategies come to rest, under each of these goals.
SceneView stage_view_of(const Settings& settings, std::span<const Vector<2>> goals);
SceneView stage_view_of(const Settings& settings, const Vector<2>& goal);

// A force for reference_force: what the naïve device pushes at rest where the scene's hand ends [N].
double reference_force_of(const Settings& settings, const Vector<2>& goal);

}  // namespace ghostforce
