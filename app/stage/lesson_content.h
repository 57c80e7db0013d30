// What the stage shows of the lesson in the session. Pure; UI thread.
#pragma once

#include "app/stage/stage_content.h"
#include "app/state/session.h"

namespace ghostforce {

// Only in a lesson.
StageLesson lesson_content(const Session& session);
StageSecrets lesson_secrets(const Session& session) noexcept;
// The ring where the person thinks, or thought, that the handle comes to rest.
StageGuess lesson_guess(const Session& session);

}  // namespace ghostforce
