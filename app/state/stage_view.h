// How much of the world the stage shows, how long its arrows are, and what must be seen. Pure, any thread.
#pragma once

#include <span>
#include <vector>

#include "app/picture/camera.h"
#include "core/scene.h"

namespace ghostforce {

// Views are made for a picture that is so wide, in which what must be seen takes no more than this room. Sizes below are
// in points of that picture.
inline constexpr double stage_view_width = 960.0;
inline constexpr Vector<2> stage_view_room{650.0, 480.0};

// How long the arrow of a force is [points/N]. `greatest`: that is drawn at the same time [N].
double arrow_points_per_newton(double reference_force, double greatest) noexcept;

// What must be seen, as thick lines with round ends: handle, hand, arrow, slide, and where it all should be.
struct StageStroke {
  FitPoint from;
  FitPoint to;
  double radius;
};
// At rest under this goal, with each strategy, so that another one needs no other view.
std::vector<StageStroke> stage_strokes(const Settings& settings, const Vector<2>& goal, double reference_force);

// Of a guess where the handle comes to rest.
StageStroke guess_stroke(const Vector<2>& guess) noexcept;

// The part of the world with all that, under each of these goals, and with a guess.
SceneView stage_view_of(const Settings& settings, std::span<const Vector<2>> goals, double reference_force,
                        const std::optional<Vector<2>>& guess = {});
// The same where the hand is where the scene has it in the end.
SceneView stage_view_of(const Settings& settings, const Vector<2>& goal);

// All of a device, as it stands there.
SceneView stage_view_of(const LinkagePose& pose);

// As far as the joints of a device let its handle come.
SceneView workspace_view(const Settings& settings);

// A force for reference_force: what the naïve device pushes at rest where the scene's hand ends [N].
double reference_force_of(const Settings& settings, const Vector<2>& goal);

}  // namespace ghostforce
