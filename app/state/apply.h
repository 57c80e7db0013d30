// Does what a person does, where permit.h allows it. Edits the session alone; UI thread.
#pragma once

#include "app/state/action.h"

namespace ghostforce {

// What is left to do for the shell, in this order; nothing where it is not permitted.
Effects apply(Session& session, const Action& action);

// Whether Escape would close something or turn motors off; else it changes nothing.
bool escape_has_use(const Session& session);

}  // namespace ghostforce
