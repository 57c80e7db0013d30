// IdleShow: left alone, the stage shows the slide by itself, until somebody touches it. UI thread.
#pragma once

#include "app/session/session.h"
#include "app/view/stage/stage_attract.h"

namespace ghostforce {

class IdleShow {
 public:
  static constexpr double begins_after_s = 20.0;

  // `is_touched`: the person did something. `is_allowed`: there is nothing that must not be disturbed.
  void update(bool is_touched, bool is_allowed, double interval_s) noexcept;

  bool is_on() const noexcept { return strength_ > 0.0; }
  // How long until it begins, if nothing happens [s].
  double begins_in_s() const noexcept { return std::max(0.0, begins_after_s - idle_s_); }

  // What is shown instead of `moment`, and of which settings.
  StageShow shown_instead_of(const StageMoment& moment, const Session& session) const;

 private:
  double idle_s_ = 0.0;
  double show_s_ = 0.0;
  double strength_ = 0.0;  // 1: nothing else is shown
};

}  // namespace ghostforce
