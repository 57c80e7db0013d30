// What a person can turn: the dial of the actuated direction in the lower right corner, and the wall by its grips.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/picture/handles.h"
#include "app/picture/layers.h"
#include "app/picture/screen_box.h"
#include "app/picture/text.h"

namespace ghostforce {
namespace {

// Which way the device can push and which way it cannot.
void add_dial(const View& view, Marks& marks) {
  const ScreenPen pen{view, marks, Role::motor_axis};
  const auto [middle, radius] = motor_dial(view.camera, view.points(1.0));
  const Vector<2> center = to_world(view.camera, middle);
  const bool is_hovered = view.hovered == Handle::motor_axis;
  const Colour rim = is_hovered ? view.theme.accent : view.theme.panel_border;
  marks.push_back({Role::motor_axis, std::nullopt,
                   Marker{center, Shape::disc, radius, view.theme.background.with_alpha(225), rim,
                          view.points(is_hovered ? 2.4 : 1.2)}});
  const Vector<2> axis = direction_at(view.settings.actuated_angle);
  const Vector<2> across{-axis.y, axis.x};
  const auto arrows = [&](const Vector<2>& direction, Colour colour) {
    for (const double sign : {-1.0, 1.0}) {
      marks.push_back(
          {Role::motor_axis, std::nullopt,
           Arrow{center, center + direction * (sign * 0.92 * radius / view.camera.points_per_metre),
                 std::min(view.points(4.4), 0.11 * radius), colour, view.theme.background, view.points(0.5)}});
    }
  };
  if (strategy(view.settings.active).has_every_motor) {
    arrows(across, view.theme.text);
  } else {
    const Vector<2> reach = to_screen_direction(across) * (0.62 * radius);
    pen.line(middle - reach, middle + reach, 1.6, view.theme.faint_text,
             {view.points(3.0), view.points(4.0), view.points(3.0), view.points(4.0)});
  }
  arrows(axis, is_hovered ? view.theme.accent : view.theme.text);
}

// Two round grips on the wall.
void add_wall_grips(const View& view, Marks& marks) {
  const auto grips = wall_grips(view.settings, view.camera, view.points(1.0));
  if (!view.has_handles || !grips) return;
  const bool is_hovered = view.hovered == Handle::wall;
  for (const Vector<2>& grip : *grips) {
    marks.push_back(
        {Role::handle, std::nullopt,
         Marker{to_world(view.camera, grip), Shape::disc, view.points(grip_radius),
                is_hovered ? view.theme.accent : view.theme.background, view.theme.wall_edge, view.points(2.0)}});
  }
}

}  // namespace

void add_handles(const View& view, Marks& marks) {
  add_wall_grips(view, marks);
  if (has_motor_dial(view.settings)) add_dial(view, marks);
}

void add_dial_caption(const View& view, LabelPlacer& labels, Marks& marks) {
  if (!has_motor_dial(view.settings)) return;
  const auto [middle, radius] = motor_dial(view.camera, view.points(1.0));
  const std::string_view noun = strategy(view.settings.active).has_every_motor ? "directions" : "direction";
  std::vector<std::string> lines{fmt::format("actuated {}", noun)};
  const TextStyle style = view.drawn(small_text);
  const auto width_of = [&](const std::string& words) { return view.measure(words, style).x; };
  // Beside a small dial scale bars need the room.
  if (width_of(lines.front()) > 3.0 * radius) lines = broken_in_two(lines.front(), style, view.measure);
  Vector<2> extent(0.0, static_cast<double>(lines.size()) * style.height);
  for (const std::string& words : lines) extent.x = std::max(extent.x, width_of(words));
  const double margin = view.points(4.0);
  const double left = std::min(middle.x - 0.5 * extent.x, view.camera.size.x - margin - extent.x);
  const Vector<2> corner{left, middle.y + radius + margin};
  const ScreenBox box{corner, corner + extent};
  const bool fits = box.least.x >= 0.0 && box.least.y >= 0.0 && box.most.y <= view.camera.size.y;
  if (!fits || !labels.obstacles().is_free(box, view.points(1.0), Clearance::if_possible)) return;
  labels.keep_clear(box);
  const ScreenPen pen{view, marks, Role::motor_axis};
  pen.backdrop(box);
  Vector<2> at = corner;
  for (std::string& words : lines) {
    at.x = corner.x + 0.5 * (extent.x - width_of(words));
    pen.text(at, std::move(words), view.theme.text);
    at.y += style.height;
  }
}

}  // namespace ghostforce
