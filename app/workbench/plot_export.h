// What the plots show, as a file: a table with the numbers, or a picture of the same curves. UI thread.
#pragma once

#include <string>

#include "app/paint/file_painter.h"
#include "app/picture/moment_history.h"
#include "app/picture/trail_history.h"
#include "app/state/action.h"

namespace ghostforce {

// The file's content; the ending of `request.path` says which format. Throws Failure where the painter of pictures
// does.
std::string plot_file(const Session& session, const ShownMoment& moment, const History& history,
                      const SavePlots& request, const FilePainter& painter);

}  // namespace ghostforce
