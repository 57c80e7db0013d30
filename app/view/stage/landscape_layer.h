// The landscape as marks: "where is it bad?". A map of every wall and every hand, with a ring at the present ones, and a
// dial from naïve to optimal rendering that drains its colour away. Pure, any thread.
#pragma once

#include "app/view/camera.h"
#include "app/view/stage/landscape_layout.h"
#include "app/view/theme.h"
#include "app/view/view.h"

namespace ghostforce {

struct LandscapeView {
  const Settings& settings;
  double dial;  // from 0, naïve, to 1: what anisotropic rendering runs with
  const Theme& theme;
  Camera camera;
  double scale;  // UI scale, 1 is normal
  const MeasureText& measure;
};

// Where a strategy stands on the dial; two motors are as good as the best of one.
double landscape_dial_of(StrategyId id) noexcept;

// Where things are, as add_landscape() draws them.
LandscapeLayout landscape_layout(const LandscapeView& view) noexcept;

void add_landscape(const LandscapeView& view, Marks& marks);

}  // namespace ghostforce
