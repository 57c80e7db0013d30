// The talk: what the stage shows at each step of it, from the wall as it should be, by the ghost force, to anisotropic
// rendering, and where it matters. Edits the session; UI thread.
#pragma once

#include <cstddef>

#include "app/state/session.h"

namespace ghostforce {

// Nothing happens where there is no such step.
void go_to_talk_step(Session& session, int step);

// How many steps it has.
std::size_t talk_length() noexcept;

}  // namespace ghostforce
