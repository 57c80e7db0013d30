// IdleShow: left alone, the stage shows the slide by itself, until somebody touches it. UI thread. What it shows comes
// by closed form, so that nothing of it reaches the simulation: StageShow, pure, any thread.
#pragma once

#include "app/state/session.h"
#include "app/state/stage_moment.h"
#include "core/scene.h"

namespace ghostforce {

// One moment of the show.
struct StageShow {
  Settings settings;  // with the strategy that is active in it
  StageMoment moment;
};

// Where a person left the stage.
struct StageLeft {
  Settings settings;
  Vector<2> goal{0.0};        // [m]
  const StageMoment& moment;  // that was shown
};

// Near where the hand was left, it goes into the wall, the handle slides, the cure takes the ghost force away, and the
// hand comes back. `time_s`: since the show began; it repeats itself. `strength`: how far the hand has come on its way
// from where it was left (0) to the show's (1).
StageShow stage_show(const StageLeft& left, double time_s, double strength);

// In a lesson that waits for somebody: the hand goes into the wall and comes back, again and again, under the strategy
// that these settings have.
StageShow hand_show(const StageLeft& left, double time_s, double strength);

class IdleShow {
 public:
  static constexpr double begins_after_s = 20.0;

  // Time goes on, whether a frame is drawn or not.
  void advance(double interval_s) noexcept { idle_s_ += may_begin_ ? interval_s : 0.0; }

  // In each frame. `is_touched`: the person did something. `may_begin`: there is nothing that must not be disturbed.
  void update(bool is_touched, bool may_begin, double interval_s) noexcept;

  // It is to be seen, or about to begin.
  bool is_moving() const noexcept { return is_on() || idle_s_ >= begins_after_s; }
  bool is_on() const noexcept { return strength_ > 0.0; }

  // What is shown instead of `moment`, and of which settings.
  StageShow shown_instead_of(const StageMoment& moment, const Session& session) const;

 private:
  bool may_begin_ = false;  // as far as the newest frame knows
  double idle_s_ = 0.0;
  double show_s_ = 0.0;
  double strength_ = 0.0;  // 1: nothing else is shown
};

}  // namespace ghostforce
