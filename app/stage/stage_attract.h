// What the stage shows by itself when nobody has touched it for a while: a hand goes into the wall, the handle slides,
// the cure takes the ghost force away, and the hand comes back. By closed form, so that nothing of it reaches the
// simulation. Pure, any thread.
#pragma once

#include "app/state/stage_moment.h"
#include "core/scene.h"

namespace ghostforce {

struct StageShow {
  Settings settings;  // with the strategy that is active in it
  StageMoment moment;
};

// `time_s`: since it began; it repeats itself.
StageShow stage_show(const Scene& scene, const Settings& settings, double time_s);

// In a lesson that waits for somebody: a hand goes from `goal` into the wall and comes back, again and again, under the
// strategy that these settings have.
StageShow hand_show(const Settings& settings, const Vector<2>& goal, double time_s);

// Between two moments, for a soft fade from one to the other: 0 is the first.
StageMoment mixed_moment(const StageMoment& first, const StageMoment& second, double share) noexcept;

}  // namespace ghostforce
