// View: all that a layer needs to draw one picture of a moment, (settings, snapshot, history, camera, theme), and what
// the person wants to see of it. Values, read only; any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "app/picture/camera.h"
#include "app/picture/marks.h"
#include "app/picture/theme.h"
#include "app/picture/trail_history.h"
#include "core/mechanism.h"
#include "core/settings.h"
#include "core/snapshot.h"

namespace ghostforce {

// How the strategies are set against each other.
enum class Compare : std::uint8_t {
  overlay,       // all strategies in one picture, the active one in front
  side_by_side,  // a pane for each
  active_only,
};
struct CompareMode {
  Compare id;
  std::string_view name;   // in files and on the command line
  std::string_view title;  // on screen
};
std::span<const CompareMode> compare_catalog() noexcept;
std::string_view compare_name(Compare id) noexcept;
// Empty when none has that name.
std::optional<Compare> find_compare(std::string_view name) noexcept;

// What the person wants to see of it all.
struct ViewOptions {
  Compare compare = Compare::overlay;
  bool ghost_forces = true;
  bool predictions = true;
  bool trails = true;

  friend bool operator==(const ViewOptions&, const ViewOptions&) = default;
};

// What the pointer can take hold of in the scene (view/handles.h).
enum class Handle : std::uint8_t { none, motor_axis, wall };

// Width and height of a line of text [points] in a style whose height is the one that is drawn: after the UI scale.
using MeasureText = std::function<Vector<2>(std::string_view text, const TextStyle& style)>;

struct View {
  const Settings& settings;
  const Snapshot& snapshot;
  const History& history;
  const Theme& theme;
  Camera camera;
  ViewOptions options;
  double scale;              // UI scale, 1 is normal
  double points_per_newton;  // of arrows; the same in all that is to be compared
  const MeasureText& measure;
  bool has_handles = false;              // a person can turn wall and motor axis here
  Handle hovered = Handle::none;         // the one under the pointer
  bool is_goal_hot = false;              // a hint speaks of it
  bool is_pane = false;                  // one of several: its title says which, and no legend is needed
  bool has_scales = true;                // of several panes, one shows the scale bars
  std::optional<double> turn_s{};        // of the circle test, once there is a turn to show
  std::optional<Vector<2>> target{};     // on the wall, for the hand at a device to aim at [m]
  std::optional<LinkagePose> linkage{};  // of a real device; empty: the settings say what there is

  bool shows(StrategyId id) const noexcept { return options.compare == Compare::overlay || id == settings.active; }
  bool in_front(StrategyId id) const noexcept { return id == settings.active; }
  // Simulated beside a device that is measured.
  bool is_predicted(StrategyId id) const noexcept { return snapshot.measured && *snapshot.measured != id; }
  // A size in points, grown by the UI scale and the theme.
  double points(double size) const noexcept { return size * scale * theme.thickness; }
  // As it is drawn.
  TextStyle drawn(const TextStyle& style) const noexcept { return {points(style.height), style.is_bold}; }
  // How long that is in the world [m].
  double metres(double size) const noexcept { return size * scale * theme.thickness / camera.points_per_metre; }
};

// Calls visit(id) for the shown strategies, the active one last, so that it ends up on top.
template <typename Visit>
void for_each_shown(const View& view, Visit&& visit) {
  for (const Strategy& entry : strategy_catalog()) {
    if (!view.in_front(entry.id) && view.shows(entry.id)) visit(entry.id);
  }
  visit(view.settings.active);
}

}  // namespace ghostforce
