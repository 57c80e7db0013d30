// The landscape as marks: "where is it bad?". A map of every wall and every hand, with a ring at the present ones, and a
// dial from naïve to optimal rendering that drains its colour away. Pure, any thread.
#pragma once

#include "app/view/marks.h"
#include "app/view/stage/landscape_view.h"

namespace ghostforce {

// Where a strategy stands on the dial; two motors are as good as the best of one.
double landscape_dial_of(StrategyId id) noexcept;

void add_landscape(const LandscapeView& view, Marks& marks);

}  // namespace ghostforce
