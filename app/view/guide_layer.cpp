#include <fmt/format.h>

#include <algorithm>

#include "app/view/handles.h"
#include "app/view/layers.h"
#include "core/units.h"

namespace ghostforce {
namespace {

constexpr double least_room_for_legend = 440.0;  // across; marks have letters besides [points]
constexpr double least_room_for_scales = 190.0;  // beside the motor dial [points]
constexpr double margin = 18.0;                  // to the edge of the picture [points]

struct Pen {
  const View& view;
  Marks& marks;
  Role role;

  // From here on positions are points of the screen.
  void line(const Vector<2>& from, const Vector<2>& to, double width, Colour colour,
            LinePattern pattern = solid_line) const {
    marks.push_back(
        {role, std::nullopt,
         Line{to_world(view.camera, from), to_world(view.camera, to), view.points(width), colour, pattern}});
  }
  void text(const Vector<2>& upper_left, std::string words, Colour colour, const TextStyle& style = small_text) const {
    marks.push_back({role, std::nullopt,
                     Label{to_world(view.camera, upper_left), Vector<2>(0.0), std::move(words), style, colour,
                           view.theme.background}});
  }
};

double text_width(const View& view, std::string_view words) {
  return view.measure(words, view.drawn(small_text)).x;
}

// The greatest of 1, 2, 5, 10, 20 … mm that is at most `longest` points long.
double round_length(const View& view, double longest) {
  double metres = 0.001;
  for (const double step : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
    if (step * 0.001 * view.camera.points_per_metre <= view.points(longest)) metres = step * 0.001;
  }
  return metres;
}

void add_scales(const View& view, Marks& marks) {
  const Pen pen{view, marks, Role::scale};
  const double tick = view.points(4.0);
  const auto bar = [&](double bottom, double length, std::string words) {
    const Vector<2> from{view.points(margin), view.camera.size.y - view.points(bottom)};
    const Vector<2> to = from + Vector<2>(length, 0.0);
    pen.line(from, to + Vector<2>(view.points(8.0) + text_width(view, words), 0.0), 21.0,
             view.theme.background.with_alpha(215));
    pen.line(from, to, 2.0, view.theme.text);
    for (const Vector<2>& end : {from, to})
      pen.line(end - Vector<2>(0.0, tick), end + Vector<2>(0.0, tick), 2.0, view.theme.text);
    pen.text(to + Vector<2>(view.points(8.0), -0.62 * view.points(small_text.height)), std::move(words),
             view.theme.text);
  };
  // In a narrow pane the motor dial is close.
  const double metres = round_length(view, std::min(110.0, 0.22 * view.camera.size.x / view.points(1.0)));
  bar(margin, metres * view.camera.points_per_metre, fmt::format("{:g} mm", metres * mm_per_m));
  bar(margin + 22.0, view.points(points_per_newton(view)), "1 N");
}

// Which way the device can push and which way it cannot, as a dial in the lower right corner.
void add_motor_axis(const View& view, Marks& marks) {
  const Pen pen{view, marks, Role::motor_axis};
  const auto [middle, radius] = motor_dial(view.camera, view.points(1.0));
  const Vector<2> center = to_world(view.camera, middle);
  const bool is_hovered = view.hovered == Handle::motor_axis;
  const Colour rim = is_hovered ? view.theme.accent : view.theme.panel_border;
  marks.push_back({Role::motor_axis, std::nullopt,
                   Marker{center, Shape::disc, radius, view.theme.background.with_alpha(225), rim,
                          view.points(is_hovered ? 2.4 : 1.2)}});
  const Vector<2> axis = direction_at(view.settings.actuated_angle);
  const Vector<2> across{-axis.y, axis.x};
  const auto motor = [&](const Vector<2>& direction, Colour colour) {
    for (const double sign : {-1.0, 1.0}) {
      marks.push_back(
          {Role::motor_axis, std::nullopt,
           Arrow{center, center + direction * (sign * 0.92 * radius / view.camera.points_per_metre),
                 std::min(view.points(4.4), 0.11 * radius), colour, view.theme.background, view.points(0.5)}});
    }
  };
  const bool every_motor = strategy(view.settings.active).has_every_motor;
  if (every_motor) {
    motor(across, view.theme.text);
  } else {
    const Vector<2> reach = to_screen_direction(across) * (0.62 * radius);
    pen.line(middle - reach, middle + reach, 1.6, view.theme.faint_text,
             {view.points(3.0), view.points(4.0), view.points(3.0), view.points(4.0)});
  }
  motor(axis, is_hovered ? view.theme.accent : view.theme.text);
  const std::string_view words = every_motor ? "motor axes" : "motor axis";
  pen.text({middle.x - 0.5 * text_width(view, words), middle.y + radius + view.points(4.0)}, std::string(words),
           view.theme.text);
}

// Two round grips on the wall, where a person can turn it.
void add_wall_grips(const View& view, Marks& marks) {
  const auto grips = wall_grips(wall_of(view.settings), view.camera, view.points(1.0));
  if (!view.has_handles || !grips) return;
  const bool is_hovered = view.hovered == Handle::wall;
  for (const Vector<2>& grip : *grips) {
    marks.push_back(
        {Role::handle, std::nullopt,
         Marker{to_world(view.camera, grip), Shape::disc, view.points(grip_radius),
                is_hovered ? view.theme.accent : view.theme.background, view.theme.wall_edge, view.points(2.0)}});
  }
}

// Whose pane this is.
void add_title(const View& view, Marks& marks) {
  const Pen pen{view, marks, Role::legend};
  const Strategy& entry = strategy(view.settings.active);
  const std::size_t i = index_of(entry.id);
  const Vector<2> at{view.points(margin + 6.0), view.points(margin + 6.0)};
  marks.push_back({Role::legend, entry.id,
                   Marker{to_world(view.camera, at), strategy_style(entry.id).shape, view.points(8.0),
                          view.theme.strategy[i], view.theme.background, view.points(1.0)},
                   Role::device});
  const std::string letter(1, entry.letter);
  const std::string in_full = fmt::format("{}  {}", entry.letter, entry.title);
  const double height = view.points(normal_text.height);
  const double left = at.x + view.points(18.0);
  const bool fits = left + view.measure(in_full, view.drawn(normal_text)).x < view.camera.size.x - view.points(4.0);
  pen.text({left, at.y - 0.6 * height}, fits ? in_full : letter, view.theme.strategy_text[i], normal_text);
  marks.back().strategy = entry.id;
  marks.back().about = Role::device;
}

void add_legend(const View& view, Marks& marks) {
  const Pen pen{view, marks, Role::legend};
  const double row_height = view.points(22.0);
  const double text_x = view.points(margin + 26.0);
  const double text_up = 0.62 * view.points(small_text.height);
  Vector<2> at{view.points(margin + 8.0), view.points(margin + 8.0)};
  const auto entry = [&](Role about, std::optional<StrategyId> id, Marker marker, std::string words, Colour colour) {
    // Trails and grid may run below: they step back behind the words.
    pen.line(at, {text_x + text_width(view, words), at.y}, 22.0, view.theme.background.with_alpha(215));
    marker.center = to_world(view.camera, at);
    marks.push_back({Role::legend, id, marker, about});
    pen.text({text_x, at.y - text_up}, std::move(words), colour);
    marks.back().strategy = id;
    marks.back().about = about;
    at.y += row_height;
  };
  const auto marker = [&](Shape shape, double radius, Colour fill, Colour rim, double rim_width) {
    return Marker{Vector<2>(0.0), shape, view.points(radius), fill, rim, view.points(rim_width)};
  };
  if (view.snapshot.measured) {
    entry(Role::goal, std::nullopt,
          marker(Shape::disc, 6.5, view.theme.goal.with_alpha(0),
                 view.theme.dark ? view.theme.goal : view.theme.goal_rim, 2.4),
          "goal: where the hand seems to pull to", view.theme.text);
  } else {
    entry(Role::goal, std::nullopt, marker(Shape::disc, 6.5, view.theme.goal, view.theme.goal_rim, 1.8),
          "goal: where the hand pulls to", view.theme.text);
  }
  for (const Strategy& each : strategy_catalog()) {
    if (!view.shows(each.id)) continue;
    const std::size_t i = index_of(each.id);
    const Colour fill = view.is_predicted(each.id) ? view.theme.background : view.theme.strategy[i];
    const Colour rim = view.is_predicted(each.id) ? view.theme.strategy[i] : view.theme.background;
    const std::string_view in_brief = view.is_predicted(each.id)          ? "simulated beside it"
                                      : view.snapshot.measured == each.id ? "measured, in your hand"
                                                                          : each.in_brief;
    entry(Role::device, each.id, marker(strategy_style(each.id).shape, 7.0, fill, rim, 1.0),
          fmt::format("{}  {}: {}", each.letter, each.title, in_brief), view.theme.strategy_text[i]);
  }
  const Colour active = view.theme.strategy[index_of(view.settings.active)];
  entry(Role::proxy, std::nullopt,
        marker(strategy_style(view.settings.active).shape, 6.0, view.theme.background, active, 1.8),
        "proxy: what the wall holds back", view.theme.text);
  if (view.options.predictions) {
    entry(Role::prediction, std::nullopt, marker(Shape::disc, 7.0, active.with_alpha(0), active, 1.0),
          "ring: where theory says it rests", view.theme.text);
  }
}

}  // namespace

void add_guides(const View& view, Marks& marks) {
  if (view.is_pane) {
    add_title(view, marks);
  } else if (view.camera.size.x > view.points(least_room_for_legend)) {
    add_legend(view, marks);
  }
  if (view.has_scales && view.camera.size.x > view.points(least_room_for_scales)) add_scales(view, marks);
}

void add_handles(const View& view, Marks& marks) {
  add_wall_grips(view, marks);
  add_motor_axis(view, marks);
}

}  // namespace ghostforce
