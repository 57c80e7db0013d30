#include "app/picture/panes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <utility>

#include "app/picture/layers.h"

namespace ghostforce {
namespace {

constexpr double gap = 2.0;                   // between panes [points]
constexpr double usual_newton_length = 30.0;  // in one picture [points]

Vector<2> pane_size(const Vector<2>& size, double scale) {
  const double count = static_cast<double>(strategy_count);
  return {std::max(1.0, (size.x - (count - 1.0) * gap * scale) / count), size.y};
}

struct PaneFrame {
  Vector<2> corner;
  Camera camera;
  double points_per_newton;
  bool is_pane = false;
  bool has_scales = true;
};

Pane compose_pane(const PictureContent& content, const Settings& settings, const PaneFrame& frame, PaneMemory& memory,
                  double interval_s, Marks earlier) {
  Pane pane{frame.corner, frame.camera, settings.active, {}};
  pane.marks = compose({.settings = settings,
                        .snapshot = content.snapshot,
                        .history = content.history,
                        .theme = content.theme,
                        .camera = pane.camera,
                        .options = content.options,
                        .scale = content.scale,
                        .points_per_newton = frame.points_per_newton * content.arrow_scale,
                        .measure = content.measure,
                        .has_handles = content.has_handles,
                        .hovered = content.hovered,
                        .is_goal_hot = content.is_goal_hot,
                        .is_pane = frame.is_pane,
                        .has_scales = frame.has_scales,
                        .turn_s = content.turn_s,
                        .target = content.target,
                        .linkage = content.linkage},
                       memory, interval_s, std::move(earlier));
  return pane;
}

}  // namespace

std::vector<Pane> compose_panes(const PictureContent& content, PictureMemory& memory, double interval_s,
                                std::vector<Pane> earlier) {
  std::vector<Pane> panes;
  const auto marks_of_earlier = [&](std::size_t place) {
    return place < earlier.size() ? std::move(earlier[place].marks) : Marks();
  };
  const double unit = content.scale * content.theme.thickness;
  if (content.options.compare != Compare::side_by_side) {
    const Camera camera = camera_on(content.shown.center, content.shown.width, content.size);
    panes.push_back(compose_pane(content, content.settings, {Vector<2>(0.0), camera, usual_newton_length * unit},
                                 memory[0], interval_s, marks_of_earlier(0)));
    // What is not there begins anew when it comes back.
    std::ranges::fill(memory | std::views::drop(1), PaneMemory());
    return panes;
  }
  const Vector<2> size = pane_size(content.size, content.scale);
  const PaneViews views = content.pane_views ? *content.pane_views : fitted_pane_views(content);
  for (const Strategy& entry : strategy_catalog()) {
    Settings settings = content.settings;
    settings.active = entry.id;
    const std::size_t i = index_of(entry.id);
    const PaneFrame frame{{static_cast<double>(i) * (size.x + gap * content.scale), 0.0},
                          camera_on(views.centers[i], views.width, size),
                          views.share_per_newton * size.x,
                          true,
                          i == 0};
    panes.push_back(compose_pane(content, settings, frame, memory[i], interval_s, marks_of_earlier(i)));
  }
  return panes;
}

std::vector<Pane> compose_panes(const PictureContent& content) {
  PictureMemory memory;
  return compose_panes(content, memory, 0.0);
}

PaneViews fitted_pane_views(const PictureContent& content) {
  return fitted_pane_views(content.settings, content.snapshot, pane_size(content.size, content.scale),
                           content.scale * content.theme.thickness, content.arrow_scale);
}

const Pane& pane_at(const std::vector<Pane>& panes, const Vector<2>& point) {
  const auto distance = [&](const Pane& pane) {
    return glm::distance(point, glm::clamp(point, pane.corner, pane.corner + pane.camera.size));
  };
  return *std::ranges::min_element(panes, {}, distance);
}

namespace {

bool has_short_force(const View& view) {
  const auto force = drawn_force(view);
  return force && std::abs(force->share + force->ghost) < view.points(2.0 * device_radius);
}

}  // namespace

Marks compose(const View& view, PaneMemory& memory, double interval_s, Marks earlier) {
  Marks marks = std::move(earlier);
  marks.clear();
  add_wall(view, marks);
  add_mechanism(view, marks);
  if (view.options.trails) add_trails(view, marks);
  add_loop(view, marks);
  add_hand(view, marks);
  add_goal(view, marks);
  add_others(view, marks);
  if (view.options.predictions) add_predictions(view, marks);
  add_target(view, marks);
  add_proxy(view, marks);
  add_drift(view, marks);
  // The arrow begins below the device, unless it is so short that this would hide it.
  const bool is_hidden = has_short_force(view);
  if (!is_hidden) add_force(view, marks);
  add_device(view, marks);
  if (is_hidden) add_force(view, marks);
  add_goal_in_device(view, marks);
  add_handles(view, marks);

  LabelPlacer labels(view.camera.size, view.points(1.0), view.measure, memory.labels, interval_s);
  keep_marks_clear(view, marks, labels);
  add_dial_caption(view, labels, marks);
  add_legend(view, labels, memory.legend, marks);
  if (view.has_scales) add_scales(view, labels, memory.scales, marks);
  add_labels(view, labels, marks);
  return marks;
}

namespace {

constexpr std::array compare_modes{
    CompareMode{Compare::overlay, "overlay", "Overlay"},
    CompareMode{Compare::side_by_side, "side-by-side", "Side by side"},
    CompareMode{Compare::active_only, "active-only", "Active only"},
};

}  // namespace

std::span<const CompareMode> compare_catalog() noexcept {
  return compare_modes;
}

std::string_view compare_name(Compare id) noexcept {
  return compare_modes[static_cast<std::size_t>(id)].name;
}

std::optional<Compare> find_compare(std::string_view name) noexcept {
  for (const CompareMode& mode : compare_modes) {
    if (mode.name == name) return mode.id;
  }
  return std::nullopt;
}

}  // namespace ghostforce
