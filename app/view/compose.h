// compose: (settings, snapshot, history, camera, theme) → marks, and nothing else. Reads no clock, no device, no
// global: the same input gives the same picture, in the window, in a PNG and in a test. One file per layer.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "app/theme.h"
#include "app/view/camera.h"
#include "app/view/history.h"
#include "app/view/marks.h"
#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

enum class Compare : std::uint8_t {
  overlay,  // all strategies in one picture, the active one in front
  active_only,
};

// Width and height of a line of text [points] at a height of text [points].
using MeasureText = std::function<Vector<2>(std::string_view text, double height)>;

struct View {
  const Settings& settings;
  const Snapshot& snapshot;
  const History& history;
  const Theme& theme;
  Camera camera;
  Compare compare;
  double scale;  // UI scale, 1 is normal
  const MeasureText& measure;

  bool shows(StrategyId id) const noexcept { return compare == Compare::overlay || id == settings.active; }
  bool in_front(StrategyId id) const noexcept { return id == settings.active; }
  // A size in points, grown by the UI scale and the theme.
  double points(double size) const noexcept { return size * scale * theme.thickness; }
  // How long that is in the world [m].
  double metres(double size) const noexcept { return size * scale * theme.thickness / camera.points_per_metre; }
};

Marks compose(const View& view);

// Calls visit(id) for the shown strategies, the active one last, so that it ends up on top.
template <typename Visit>
void for_each_shown(const View& view, Visit&& visit) {
  for (const Strategy& entry : strategy_catalog()) {
    if (!view.in_front(entry.id) && view.shows(entry.id)) visit(entry.id);
  }
  visit(view.settings.active);
}

}  // namespace ghostforce
