// Does what a person does, where permit.h allows it. Edits the session alone; UI thread.
#pragma once

#include <cstddef>

#include "app/state/action.h"

namespace ghostforce {

// What is left to do for the shell, in this order; nothing where it is not permitted.
Effects apply(Session& session, const Action& action);

// How many steps the talk has that a clicker goes through.
std::size_t talk_length() noexcept;

}  // namespace ghostforce
