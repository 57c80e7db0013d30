// VisibleState: what a frame shows of servo, input and session that can change while the person does nothing, as a
// value that outlives them. Two that do not look other make the same picture. UI thread.
#pragma once

#include <optional>
#include <string>

#include "app/picture/moment_history.h"
#include "app/picture/trail_history.h"
#include "app/state/session.h"

namespace ghostforce {

struct VisibleState {
  Snapshot snapshot;  // of the moment that is shown
  Settings settings;
  bool is_past = false;
  bool is_paused = false;
  Vector<2> goal{0.0};                 // the session's [m]
  std::optional<std::string> notice;   // its words
  std::optional<double> plots_end_s;   // of the plots over time, while the present is in sight
  std::optional<double> ribbon_end_s;  // of the last minute, while that is on the stage
  std::optional<double> trail_s;       // of the moment, while a trail of it is fading
  Theme theme{};
  std::string words;  // that name what is so, or what to do: warnings, readiness, motors, recording
};

// `present_s`: model time of the newest tick.
VisibleState visible_state(const Session& session, const ShownMoment& shown, const History& history, double present_s,
                           const LoopReading& reading);

// Whether a person could see it, in a picture so fine [points/m].
bool differs_visibly(const VisibleState& seen, const VisibleState& now, double points_per_metre) noexcept;

}  // namespace ghostforce
