// The landscape as marks: "where is it bad?". A map of every wall and every hand, with a ring at the present ones, and
// a dial from naïve to optimal rendering that drains the map's colour away. Pure, any thread.
#pragma once

#include <string>

#include "app/picture/marks.h"
#include "app/stage/landscape_layout.h"

namespace ghostforce {

// What stands beside the map about this wall and this hand, as one sentence.
std::string landscape_sentence(const LandscapeView& view);

void add_landscape(const LandscapeView& view, Marks& marks);

}  // namespace ghostforce
