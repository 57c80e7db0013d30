// The pictures of a worksheet: the stage of a lesson's step, as one that nobody has answered or as the answer leaves it,
// without what surrounds the stage on a screen. Throws what simulate_to_moment() does. One thread at a time.
#pragma once

#include <memory>
#include <string>

#include "app/lessons/lesson.h"
#include "app/view/panes.h"
#include "app/worksheet/worksheet_item.h"
#include "app/worksheet/worksheet_layout.h"

namespace ghostforce {

Pane worksheet_picture(const std::shared_ptr<const Lesson>& lesson, const std::string& language, WorksheetSide side,
                       const WorksheetPicture& picture);

}  // namespace ghostforce
