// What the page tells of itself to scripts: those of a course page, and tests. Main thread.
#pragma once

#include <string>

#include "core/conventions.h"

namespace ghostforce {

class Page;

// What is on the screen and how it goes, as JSON; docs/web.md lists the keys.
std::string page_state(Page& page);

// The rows that `ghostforce simulate SCENE --strategy NAME` writes. Throws ReadError or Failure where there is no
// such scene or strategy.
std::string simulated_rows(const std::string& scene_name, const std::string& strategy_name);

// Replays a recording, as `ghostforce replay` does: whether the page's own numbers are the same, as JSON. Throws
// ReadError where the text is no recording.
std::string replayed(const std::string& recording);

// Where a point of the world [m] is on the page [CSS pixels, y down].
Vector<2> on_page(Page& page, const Vector<2>& world);

}  // namespace ghostforce
