// The ribbon: the last minute along the lower edge of the stage, with the ghost force of all three strategies over it.
// A person drags along it to look at a moment again.
//
// Its right end is "now": the last tick that changed anything that can be seen (MomentHistory::changed_s). So it stands
// still at rest, however long that lasts, and the same history gives the same marks. Pure, any thread; screen points
// have their origin at the picture's upper left corner, y down.
#pragma once

#include <optional>

#include "app/picture/camera.h"
#include "app/picture/marks.h"
#include "app/picture/moment_history.h"
#include "app/picture/screen_box.h"
#include "app/picture/view.h"
#include "app/state/stage_language.h"

namespace ghostforce {

struct Ribbon {
  const MomentHistory& moments;
  std::optional<double> looks_back_to_s;  // the moment that is shown, model time; empty: now
  const StageLanguage& language;
  const Theme& theme;
  const MeasureText& measure;
  Camera camera;  // of the picture that it is part of
  ScreenBox box;  // all of it, words too [points]
};

// Time along the ribbon.
struct RibbonAxis {
  double left = 0.0;      // where it begins [points]
  double right = 1.0;     // now
  double end_s = 0.0;     // there, model time
  double oldest_s = 0.0;  // nothing is kept from before

  // Times outside are at the ends.
  double x_at(double time_s) const noexcept;
  // Under a pointer, of what is kept; empty at the right end and beyond: now.
  std::optional<double> time_at(double x) const noexcept;
};
RibbonAxis ribbon_axis(const Ribbon& ribbon) noexcept;

// The height that it needs for everything: a line of words above and below the curves [points].
double ribbon_height(const Ribbon& ribbon);

// In a lower box words go, the least important first.
void add_ribbon(const Ribbon& ribbon, Marks& marks);

}  // namespace ghostforce
