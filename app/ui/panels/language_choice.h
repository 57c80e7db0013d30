// The language of the stage and of lessons, one of the catalog. Within a frame, UI thread.
#pragma once

#include "app/session/session.h"

namespace ghostforce {

void draw_language_choice(Session& session);

}  // namespace ghostforce
