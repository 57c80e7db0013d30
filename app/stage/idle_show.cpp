#include "app/stage/idle_show.h"

#include <algorithm>

namespace ghostforce {
namespace {

constexpr double fades_in_s = 1.2;
constexpr double fades_out_s = 0.25;

}  // namespace

void IdleShow::update(bool is_touched, bool may_begin, double interval_s) noexcept {
  may_begin_ = may_begin;
  if (is_touched || !may_begin) idle_s_ = 0.0;
  if (idle_s_ >= begins_after_s) {
    show_s_ += interval_s;
    strength_ = std::min(1.0, strength_ + interval_s / fades_in_s);
    return;
  }
  strength_ = std::max(0.0, strength_ - interval_s / fades_out_s);
  if (strength_ == 0.0) show_s_ = 0.0;
}

StageShow IdleShow::shown_instead_of(const StageMoment& moment, const Session& session) const {
  StageShow show = session.lesson ? hand_show(session.settings, session.goal, show_s_)
                                  : stage_show(*session.scene, session.settings, show_s_);
  show.moment = mixed_moment(moment, show.moment, strength_);
  if (strength_ < 0.5) show.settings.active = session.settings.active;
  return show;
}

}  // namespace ghostforce
