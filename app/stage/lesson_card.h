// The picture by which a lesson is chosen: of the stage in one of its steps. Pure; UI thread.
#pragma once

#include <cstddef>

#include "app/picture/panes.h"
#include "app/picture/theme.h"

namespace ghostforce {

// Of a lesson of shipped_lessons(). `size` [px]; `scale`: of lines and marks, in pixels.
Pane lesson_card(std::size_t number, const Theme& theme, const Vector<2>& size, double scale);

}  // namespace ghostforce
