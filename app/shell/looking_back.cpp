#include "app/shell/looking_back.h"

#include <algorithm>
#include <utility>

namespace ghostforce {
namespace {

// Beyond the present they are steps of the servo.
void go_through(int ticks, Session& session, const Snapshot& present, const MomentHistory& moments) {
  double time_s = shown_moment(session, present, moments).snapshot.time_s;
  for (; ticks < 0; ++ticks) {
    const std::optional<ShownMoment> before = moments.before(time_s);
    if (!before) break;
    time_s = before->snapshot.time_s;
  }
  for (; ticks > 0 && time_s < present.time_s; --ticks) {
    const std::optional<ShownMoment> after = moments.after(time_s);
    time_s = after ? after->snapshot.time_s : present.time_s;
  }
  session.steps_asked += static_cast<std::uint32_t>(std::max(0, ticks));
  session.stage.looks_back_to_s = time_s;
}

}  // namespace

ShownMoment shown_moment(const Session& session, const Snapshot& present, const MomentHistory& moments) {
  const std::optional<double> time_s = session.stage.looks_back_to_s;
  if (!time_s || !(*time_s < present.time_s) || moments.is_empty()) {
    return {settings_at(*session.scene, session.settings, present.time_s), present};
  }
  ShownMoment past = *(*time_s < moments.oldest()->snapshot.time_s ? moments.oldest() : moments.at(*time_s));
  past.settings = settings_at(*session.scene, past.settings, past.snapshot.time_s);
  past.settings.active = session.settings.active;
  return past;
}

void LookingBack::follow(Session& session, const Snapshot& present, const MomentHistory& moments) {
  std::optional<double>& time_s = session.stage.looks_back_to_s;
  // A moment is there for all strategies: another active one is no change of it.
  settings_.active = session.settings.active;
  const Settings chosen = chosen_settings(session.settings, session.belief_source);
  const bool has_changed = std::exchange(settings_, chosen) != chosen;
  const bool has_moved = std::exchange(goal_, session.goal) != session.goal || session.drags_goal;
  if (has_changed || has_moved) time_s.reset();
  if (const int ticks = std::exchange(session.ticks_through_history, 0); ticks != 0) {
    go_through(ticks, session, present, moments);
  }
  if (!time_s) return;
  // Time goes on: what is looked at may be forgotten meanwhile. What is not past is the present.
  if (!moments.is_empty()) time_s = std::max(*time_s, moments.oldest()->snapshot.time_s);
  if (!(*time_s < present.time_s)) time_s.reset();
}

}  // namespace ghostforce
