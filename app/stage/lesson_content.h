// What the stage shows of the lesson in the session, and the small picture by which a lesson is chosen. Pure; UI
// thread.
#pragma once

#include <cstddef>

#include "app/picture/panes.h"
#include "app/picture/theme.h"
#include "app/stage/stage_content.h"
#include "app/state/session.h"

namespace ghostforce {

// Only in a lesson.
StageLesson lesson_content(const Session& session);
StageSecrets lesson_secrets(const Session& session) noexcept;
// The ring where the person thinks, or thought, that the handle comes to rest.
StageGuess lesson_guess(const Session& session);

// The picture by which a lesson of shipped_lessons() is chosen: of the stage in one of its steps. `size` [px]; `scale`:
// of lines and marks, in pixels.
Pane lesson_card(std::size_t number, const Theme& theme, const Vector<2>& size, double scale);

}  // namespace ghostforce
