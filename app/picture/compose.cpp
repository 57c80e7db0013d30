#include "app/picture/compose.h"

#include <array>
#include <cmath>
#include <utility>

#include "app/picture/layers.h"

namespace ghostforce {
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
