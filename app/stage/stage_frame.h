// StageFrame: what a frame of the stage is made from. Refers to what others hold for as long as the frame lasts.
#pragma once

#include "app/picture/moment_history.h"
#include "app/picture/shown_moment.h"
#include "app/picture/view.h"
#include "app/state/session.h"

namespace ghostforce {

struct StageFrame {
  const ShownMoment& shown;
  const History& history;
  const LoopReading& loop;
  const Theme& theme;
  const MeasureText& measure;
  Vector<2> size;        // of the window [points]
  double scale;          // UI scale
  bool is_bare = false;  // see StageContent
};

}  // namespace ghostforce
