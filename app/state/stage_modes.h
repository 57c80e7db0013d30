// The beginning and the end of a mode of the stage, whoever asks for it. Edits the session; UI thread.
#pragma once

#include "app/state/session.h"

namespace ghostforce {

// Another mode ends. The stage is to be shown already.
void begin_stage_mode(Session& session, StageMode mode);
void leave_stage_mode(Session& session);

inline constexpr int last_why_step = 4;

}  // namespace ghostforce
