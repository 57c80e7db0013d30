// The picture of a scene: one pane, or one beside the other for the comparison. Each pane is a camera and its marks;
// together they fill the rectangle. Pure: reads no clock, no device, no global. The same input gives the same picture,
// in the window, in a PNG and in a test.
#pragma once

#include <vector>

#include "app/picture/label_placer.h"
#include "app/picture/marks.h"
#include "app/picture/pane_views.h"
#include "app/picture/view.h"
#include "core/scene.h"

namespace ghostforce {

// The marks of one pane, layer by layer (layers.h). `memory`: where words stood in the picture before, `interval_s`
// ago; as it is made: there was none. `earlier`: marks of an earlier picture, to be thrown away; the new ones take
// their room, which a screen that is drawn sixty times a second need not ask the system for each time.
Marks compose(const View& view, PaneMemory& memory, double interval_s = 0.0, Marks earlier = {});

struct Pane {
  Vector<2> corner{0.0};  // upper left, in the whole rectangle [points]
  Camera camera;          // its size is the pane's
  StrategyId active;      // whose pane it is; the active strategy where there is one pane
  Marks marks;
};

// What is to be seen, and how; `size` is the whole rectangle's [points].
struct PictureContent {
  const Settings& settings;
  const Snapshot& snapshot;
  const History& history;
  const Theme& theme;
  ViewOptions options;
  SceneView shown;                        // the part of the world in one picture,
  std::optional<PaneViews> pane_views{};  // and in panes side by side; empty: fitted to this moment
  Vector<2> size;
  double scale;              // UI scale, 1 is normal
  double arrow_scale = 1.0;  // of forces, on top of that
  const MeasureText& measure;
  bool has_handles = false;
  Handle hovered = Handle::none;
  bool is_goal_hot = false;
  std::optional<double> turn_s{};
  std::optional<Vector<2>> target{};
  std::optional<LinkagePose> linkage{};  // of a real device
};

// `memory`, `interval_s` and `earlier`: as compose() has them.
std::vector<Pane> compose_panes(const PictureContent& content, PictureMemory& memory, double interval_s,
                                std::vector<Pane> earlier = {});
// A picture alone.
std::vector<Pane> compose_panes(const PictureContent& content);

// What its panes would show, side by side, fitted to its moment.
PaneViews fitted_pane_views(const PictureContent& content);

// The pane that holds a point of the rectangle; the nearest one for a point outside. `panes` is not empty.
const Pane& pane_at(const std::vector<Pane>& panes, const Vector<2>& point);

}  // namespace ghostforce
