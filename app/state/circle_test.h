// The circle test: another input leads the goal round a circle inside the wall, near to where the person had it; at the
// end the goal is the person's again, and where it was. UI thread.
#pragma once

#include "app/state/session.h"

namespace ghostforce {

// Does nothing while it is on.
void begin_circle_test(Session& session);

void end_circle_test(Session& session);

// The circle that the goal goes round, or would.
Circle circle_of(const Session& session) noexcept;

}  // namespace ghostforce
