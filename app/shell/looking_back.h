// LookingBack: which moment the window shows: the present one, or one of the last minute at which a person looks again
// (StageChoice::looks_back_to_s). Only the picture goes back: the session's settings, the servo and what is recorded
// know nothing of it. UI thread.
#pragma once

#include "app/picture/moment_history.h"
#include "app/state/session.h"

namespace ghostforce {

// Good as long as all three stay as they are. A moment older than what is kept is the oldest.
ShownMoment shown_moment(const Session& session, const Snapshot& present, const MomentHistory& moments);

class LookingBack {
 public:
  // After each frame: goes through the ticks that were asked for, and ends where the person has changed something: a
  // setting but which strategy is active, or the goal. `present` and `moments`: those of that frame.
  void follow(Session& session, const Snapshot& present, const MomentHistory& moments);

 private:
  // What the person had chosen a frame ago.
  Settings settings_{};
  Vector<2> goal_{0.0};
};

}  // namespace ghostforce
