#include <fmt/format.h>

#include <cmath>

#include "app/view/layers.h"

namespace ghostforce {
namespace {

constexpr double margin = 18.0;  // to the edge of the picture [points]

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
  void text(const Vector<2>& upper_left, std::string words, Colour colour, TextSize size = TextSize::small,
            Colour halo = Colour{0, 0, 0, 0}) const {
    marks.push_back({role, std::nullopt,
                     Label{to_world(view.camera, upper_left), Vector<2>(0.0), std::move(words), size, colour, halo}});
  }
};

double text_width(const View& view, std::string_view words) {
  return view.measure(words, view.points(text_height(TextSize::small))).x;
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
    pen.line(from, to, 2.0, view.theme.text);
    for (const Vector<2>& end : {from, to})
      pen.line(end - Vector<2>(0.0, tick), end + Vector<2>(0.0, tick), 2.0, view.theme.text);
    pen.text(to + Vector<2>(view.points(8.0), -0.62 * view.points(text_height(TextSize::small))), std::move(words),
             view.theme.text, TextSize::small, view.theme.background);
  };
  const double metres = round_length(view, 110.0);
  bar(margin, metres * view.camera.points_per_metre, fmt::format("{:g} mm", metres * 1000.0));
  bar(margin + 22.0, view.points(points_per_newton), "1 N");
}

// Which way the device can push and which way it cannot, as a small compass in the lower right corner.
void add_motor_axis(const View& view, Marks& marks) {
  const Pen pen{view, marks, Role::motor_axis};
  const double radius = view.points(34.0);
  const double line_height = view.points(text_height(TextSize::small));
  const Vector<2> middle = view.camera.size - Vector<2>(view.points(margin) + radius + view.points(14.0),
                                                        view.points(margin) + radius + line_height);
  const Vector<2> center = to_world(view.camera, middle);
  marks.push_back({Role::motor_axis, std::nullopt,
                   Marker{center, Shape::disc, radius, view.theme.background.with_alpha(215), view.theme.panel_border,
                          view.points(1.2)}});
  const Vector<2> axis = direction_at(view.settings.actuated_angle);
  const Vector<2> across{-axis.y, axis.x};
  const auto motor = [&](const Vector<2>& direction) {
    for (const double sign : {-1.0, 1.0}) {
      marks.push_back({Role::motor_axis, std::nullopt,
                       Arrow{center, center + direction * (sign * 0.86 * radius / view.camera.points_per_metre),
                             view.points(3.6), view.theme.text, view.theme.background, view.points(0.5)}});
    }
  };
  const bool every_motor = strategy(view.settings.active).has_every_motor;
  if (every_motor) {
    motor(across);
  } else {
    const Vector<2> reach = to_screen_direction(across) * (0.62 * radius);
    pen.line(middle - reach, middle + reach, 1.6, view.theme.faint_text,
             {view.points(3.0), view.points(4.0), view.points(3.0), view.points(4.0)});
  }
  motor(axis);
  const std::string_view words = every_motor ? "motor axes" : "motor axis";
  pen.text({middle.x - 0.5 * text_width(view, words), middle.y + radius + view.points(4.0)}, std::string(words),
           view.theme.text, TextSize::small, view.theme.background);
}

void add_legend(const View& view, Marks& marks) {
  const Pen pen{view, marks, Role::legend};
  const double row_height = view.points(22.0);
  const double text_x = view.points(margin + 26.0);
  const double text_up = 0.62 * view.points(text_height(TextSize::small));
  Vector<2> at{view.points(margin + 8.0), view.points(margin + 8.0)};
  const auto entry = [&](std::optional<StrategyId> id, Shape shape, double radius, Colour fill, Colour rim,
                         double rim_width, std::string words, Colour colour) {
    marks.push_back({Role::legend, id,
                     Marker{to_world(view.camera, at), shape, view.points(radius), fill, rim, view.points(rim_width)}});
    pen.text({text_x, at.y - text_up}, std::move(words), colour, TextSize::small, view.theme.background);
    at.y += row_height;
  };
  entry(std::nullopt, Shape::disc, 6.5, view.theme.goal, view.theme.goal_rim, 1.8, "goal: where the hand pulls to",
        view.theme.text);
  for (const Strategy& each : strategy_catalog()) {
    if (!view.shows(each.id)) continue;
    const std::size_t i = index_of(each.id);
    entry(each.id, strategy_style(each.id).shape, 7.0, view.theme.strategy[i], view.theme.background, 1.0,
          fmt::format("{}  device, {}", each.letter, each.title), view.theme.strategy_text[i]);
  }
  const std::size_t active = index_of(view.settings.active);
  entry(std::nullopt, strategy_style(view.settings.active).shape, 6.0, view.theme.background,
        view.theme.strategy[active], 1.8, "proxy: what the wall holds back", view.theme.text);
}

}  // namespace

void add_guides(const View& view, Marks& marks) {
  add_legend(view, marks);
  add_scales(view, marks);
  add_motor_axis(view, marks);
}

}  // namespace ghostforce
