// What a panel gets to see and to change. A panel draws itself into the ImGui window that is current, hands what the
// person does to `apply`, and knows neither device nor thread.
#pragma once

#include <string_view>

#include <imgui.h>

#include "app/paint/label_painter.h"
#include "app/paint/scene_gallery.h"
#include "app/picture/theme.h"
#include "app/state/action.h"
#include "core/snapshot.h"

namespace ghostforce {

struct Fonts : LabelFonts {
  ImFont* number;  // all digits equally wide
};

struct PanelContext {
  const Session& session;
  const ActionSink& apply;
  Session& edited;  // the session, for what has no Action yet: forms, folds, views, plots, the age of the dial
  const Snapshot& snapshot;
  const Settings& settings;  // of the moment that is shown; the session's own, but for one of the past
  const LoopReading& loop;
  const Theme& theme;
  const Fonts& fonts;
  float scale;  // UI scale [1]
  SceneGallery& gallery;
  PictureGallery& lessons;
};

struct Panel {
  std::string_view title;
  void (*draw)(const PanelContext&);
  double opens_from = 0.0;                         // folded at first in a lower window [points]
  bool (*is_there)(const LoopReading&) = nullptr;  // null: always
  // Whether something to look at has just appeared in it; cleared once it is in sight. Null: never.
  bool& (*news)(Session&) = nullptr;
};

}  // namespace ghostforce
