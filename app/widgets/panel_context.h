// What a panel gets to see and to change. A panel draws itself into the ImGui window that is current, hands what the
// person does to `apply`, and knows neither device nor thread.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <imgui.h>

#include "app/paint/label_painter.h"
#include "app/paint/scene_gallery.h"
#include "app/picture/theme.h"
#include "app/state/action.h"
#include "app/state/session.h"
#include "core/snapshot.h"

namespace ghostforce {

struct Fonts : LabelFonts {
  ImFont* number;  // all digits equally wide
};

// What widgets keep from one frame to the next. A person chooses none of it, so there is no Action for it; the session
// holds it, and widgets may change it while they are drawn.
struct WidgetMemory {
  explicit WidgetMemory(Session& session) noexcept
      : form(session.form),
        plots(session.plots),
        folded_panels(session.folded_panels),
        recording_path(session.recording_path),
        dial_turned_s(session.dial_turned_s),
        measurement_has_news(session.measurement.has_news),
        circle_has_news(session.circle_test.has_news) {}

  Form& form;
  PlotView& plots;  // the times in sight, and the one under the pointer
  std::set<std::string, std::less<>>& folded_panels;
  std::string& recording_path;
  std::optional<double>& dial_turned_s;
  bool& measurement_has_news;
  bool& circle_has_news;
};

struct PanelContext {
  const Session& session;
  const ActionSink& apply;
  const WidgetMemory& memory;
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
  bool& (*news)(const WidgetMemory&) = nullptr;
};

}  // namespace ghostforce
