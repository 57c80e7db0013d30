// IdleShow: left alone, the stage shows the slide by itself, until somebody touches it. UI thread.
#pragma once

#include "app/stage/stage_attract.h"
#include "app/state/session.h"

namespace ghostforce {

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
