// Moments of the workbench's scene by dice, in any window with and without plots; and a picture of one, without a window.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "app/paint/vector/vector_painter.h"
#include "app/picture/panes.h"
#include "tests/app/picture/picture_dice.h"

namespace ghostforce {

// All that a picture is made of, held by value.
struct WorkbenchCase {
  Settings settings{};
  Snapshot snapshot{};
  SceneView shown{{0.0, 0.0}, 0.2};
  ViewOptions options{};
  std::optional<PaneViews> pane_views{};
  Vector<2> size{853.0, 660.0};  // of the scene
  double scale = 1.0;
  double arrow_scale = 1.0;
  std::string_view theme_name = "light";
  bool has_handles = true;
  std::optional<Vector<2>> target{};

  const Theme& theme() const { return *find_theme(theme_name); }
  double text_scale() const { return scale * theme().thickness; }
  PictureContent content() const {
    static const MeasureText measure = measure_vector_text;
    static const History history;
    return {.settings = settings,
            .snapshot = snapshot,
            .history = history,
            .theme = theme(),
            .options = options,
            .shown = shown,
            .pane_views = pane_views,
            .size = size,
            .scale = scale,
            .arrow_scale = arrow_scale,
            .measure = measure,
            .has_handles = has_handles,
            .target = target};
  }
  std::vector<Pane> compose(PictureMemory& memory, double interval_s) const {
    return compose_panes(content(), memory, interval_s);
  }
  std::vector<Pane> compose() const { return compose_panes(content()); }
  std::string words() const {
    return fmt::format("{:.0f}x{:.0f} scale {:.2f} arrows {} {} {} {}", size.x, size.y, scale, arrow_scale, theme_name,
                       compare_name(options.compare), strategy(settings.active).name);
  }
};

// As the workbench divides its window (app/shell/workbench.cpp).
inline Vector<2> scene_size_in(const Vector<2>& window, double scale, bool has_plots) {
  const double column = std::min(std::clamp(0.335 * window.x, 350.0 * scale, 470.0 * scale), 0.5 * window.x);
  const double middle = window.y - 78.0 * scale;
  const double plots = has_plots ? std::clamp(0.4 * middle, 200.0 * scale, 340.0 * scale) : 0.0;
  return glm::max(Vector<2>(window.x - column, middle - 62.0 * scale - plots), Vector<2>(1.0));
}

inline WorkbenchCase workbench_case_by(PictureDice& dice) {
  WorkbenchCase made;
  made.settings = dice.settings();
  const Vector<2> goal = dice.goal(made.settings);
  made.scale = dice.scale();
  made.size = scene_size_in(dice.size(), made.scale, dice.one_in(2));
  made.theme_name = dice.theme();
  made.arrow_scale = dice.one_of(std::array{1.0, 1.0, 0.25, 0.5, 2.0, 4.0});
  made.options.compare = dice.one_of(std::array{Compare::overlay, Compare::side_by_side, Compare::active_only});
  made.options.ghost_forces = !dice.one_in(5);
  made.options.predictions = !dice.one_in(4);
  made.has_handles = dice.one_in(2);
  made.shown = {goal, dice.decades(-1.6, -0.4)};
  const Camera camera = camera_on(made.shown.center, made.shown.width, made.size);
  const auto anywhere = [&] {
    return to_world(camera, made.size * Vector<2>(dice.between(0.0, 1.0), dice.between(0.0, 1.0)));
  };
  const Vector<2> seen = dice.one_in(2) ? goal : anywhere();
  made.snapshot =
      dice.one_in(4) ? dice.moving_snapshot(made.settings, goal, seen) : snapshot_at_rest_of_all(made.settings, seen);
  const auto has_run_away = [](const StrategySnapshot<2>& now) {
    return !(glm::length(now.device) < 10.0 && glm::length(now.force) < 1e7);
  };
  if (std::ranges::any_of(made.snapshot.strategies, has_run_away)) {
    made.snapshot = snapshot_at_rest_of_all(made.settings, seen);
  }
  if (dice.one_in(5)) {
    made.snapshot.measured = made.settings.active;
    for (auto& strategy : made.snapshot.strategies) strategy.ghost_force = strategy.proxy_drift = Vector<2>(0.0);
  }
  if (dice.one_in(5)) made.target = projection(wall_of(made.settings), anywhere());
  return made;
}

}  // namespace ghostforce
