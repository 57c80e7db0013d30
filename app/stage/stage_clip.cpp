#include "app/stage/stage_clip.h"

#include "app/stage/stage.h"

namespace ghostforce {

Pane StageClip::next(const ClipMoment& moment, double interval_s) {
  const auto& [settings, snapshot] = moment;
  if (!transition_) transition_.emplace(settings.active);
  transition_->advance(interval_s);
  // What a device shows is what it does.
  if (snapshot.measured) {
    transition_->jump_to(settings.active);
  } else {
    transition_->go_to(settings.active, false);
  }
  StageContent content{.settings = settings,
                       .moment = stage_moment_between(settings, snapshot, snapshot.goal, transition_->blend()),
                       .language = *look_.language,
                       .keys = look_.keys,
                       .theme = *look_.theme,
                       .measure = look_.measure,
                       .shown = look_.shown,
                       .reference_force = look_.reference_force,
                       .size = look_.size,
                       .scale = look_.scale,
                       .audience = {.can_drag = false, .heads_for = settings.active},
                       .has_controls = false};
  if (look_.target) content.moment = with_target(content.moment, wall_of(settings), *look_.target);
  return compose_stage(content, memory_, interval_s).pane;
}

}  // namespace ghostforce
