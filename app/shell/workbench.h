// Workbench: the face of the window for those who change and measure: bars, scene, panels and plots. Edits the session.
// Between ImGui's NewFrame and Render, UI thread.
#pragma once

#include <algorithm>
#include <vector>

#include "app/picture/moment_history.h"
#include "app/picture/panes.h"
#include "app/picture/trail_history.h"
#include "app/shell/gestures.h"
#include "app/shell/window.h"
#include "app/state/session.h"
#include "app/widgets/panel_context.h"

namespace ghostforce {

struct WorkbenchFrame {
  const ShownMoment& moment;
  const History& history;
  const MeasureText& measure;
  Part part;
  bool is_live;  // a person looks; else it is a picture for a file
  double interval_s;
};

class Workbench {
 public:
  // Of the words in the scene.
  explicit Workbench(const LabelFonts& fonts) : gestures_(fonts) {}

  // All but the scene, whose marks are for the caller to paint beneath. Fits the session's views to the picture where
  // that was asked for.
  void draw(Session& session, const PanelContext& context, const WorkbenchFrame& frame);

  const std::vector<Pane>& panes() const noexcept { return panes_; }
  // Upper left corner of the scene in the window [points].
  ImVec2 scene_corner() const noexcept { return scene_corner_; }
  // The same scene alone, for a painter of files: without handles, which are for a pointer. `scale`: of the UI, 1 is
  // normal.
  std::vector<Pane> panes_for_file(const Session& session, const ShownMoment& moment, const History& history,
                                   const LoopReading& loop, const MeasureText& measure, double scale) const;
  // Words may yet find better places, or come into sight.
  bool is_moving() const noexcept { return std::ranges::any_of(memory_, &PaneMemory::is_moving); }
  // Of the scene in the window [points].
  Vector<2> scene_size() const noexcept { return scene_size_; }

 private:
  struct Layout;
  static void draw_panels(const PanelContext& context, const Layout& layout, const History& history);
  void compose(Session& session, const PanelContext& context, const WorkbenchFrame& frame);
  // What every picture of the scene shows, on a screen or in a file.
  PictureContent content_of(const Session& session, const ShownMoment& moment, const History& history,
                            const LoopReading& loop, const MeasureText& measure, double scale) const;

  Gestures gestures_;
  std::vector<Pane> panes_;
  PictureMemory memory_;
  ImVec2 scene_corner_{0.0F, 0.0F};
  Vector<2> scene_size_{1.0};
};

}  // namespace ghostforce
