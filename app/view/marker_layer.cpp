#include "app/view/layers.h"

namespace ghostforce {
namespace {

constexpr double device_radius = 9.0;          // [points], of the active strategy
constexpr double inactive_marker_size = 0.78;  // size of the others
constexpr double goal_radius = 10.5;           // [points]

void add_proxy(const View& view, StrategyId id, Marks& marks) {
  const std::size_t i = index_of(id);
  const StrategySnapshot<2>& now = view.snapshot.strategies[i];
  if (!now.in_contact) return;  // in free space the proxy is the device
  const double size = view.in_front(id) ? 1.0 : inactive_marker_size;
  const Colour colour = view.theme.strategy[i];
  const Wall<2> wall = wall_of(view.settings);
  const double tick = view.metres(7.0 * size);
  marks.push_back({Role::tracking_link, id,
                   Line{now.device, now.proxy, view.points(1.4 * size), mix(view.theme.wall, colour, 0.7)}});
  marks.push_back(
      {Role::contact, id,
       Line{now.contact - wall.normal * tick, now.contact + wall.normal * tick, view.points(2.2 * size), colour}});
  marks.push_back({Role::proxy, id,
                   Marker{now.proxy, strategy_style(id).shape, view.points(device_radius * 0.85 * size),
                          view.theme.background, colour, view.points(2.2 * size)}});
}

// Filled: the device itself; measured, it has an eye. Hollow: it is only simulated beside a measured one.
void add_device(const View& view, StrategyId id, Marks& marks) {
  const std::size_t i = index_of(id);
  const double size = view.in_front(id) ? 1.0 : inactive_marker_size;
  const Vector<2> at = view.snapshot.strategies[i].device;
  const Shape shape = strategy_style(id).shape;
  const Colour colour = view.theme.strategy[i];
  if (view.is_predicted(id)) {
    marks.push_back({Role::device, id,
                     Marker{at, shape, view.points(0.9 * device_radius * size), view.theme.background.with_alpha(150),
                            colour, view.points(1.6)}});
    return;
  }
  marks.push_back(
      {Role::device, id,
       Marker{at, shape, view.points(device_radius * size), colour, view.theme.background, view.points(1.6)}});
  if (view.snapshot.measured == id) {
    marks.push_back(
        {Role::device, id,
         Marker{at, Shape::disc, view.points(0.3 * device_radius), view.theme.background, colour, view.points(0.5)}});
  }
}

}  // namespace

void add_hand(const View& view, Marks& marks) {
  const Vector<2> device = view.snapshot.strategies[index_of(view.settings.active)].device;
  const LinePattern dots{view.points(2.0), view.points(5.0), view.points(2.0), view.points(5.0)};
  marks.push_back({Role::hand_spring, std::nullopt,
                   Line{view.snapshot.goal, device, view.points(2.0), view.theme.faint_text, dots}});
}

void add_markers(const View& view, StrategyId id, Marks& marks) {
  add_proxy(view, id, marks);
  add_device(view, id, marks);
}

void add_goal(const View& view, Marks& marks) {
  const Vector<2> goal = view.snapshot.goal;
  const Colour rim = view.theme.goal_rim;
  const double arm = view.metres(goal_radius + 5.0);
  // Hollow: nobody gave it, it is inferred.
  const bool is_estimated = view.snapshot.measured.has_value();
  const auto disc = [&](double radius, Colour fill, Colour line, double width) {
    marks.push_back(
        {Role::goal, std::nullopt, Marker{goal, Shape::disc, view.points(radius), fill, line, view.points(width)}});
  };
  if (is_estimated) {
    disc(goal_radius, rim.with_alpha(0), rim, 5.2);
    disc(goal_radius, rim.with_alpha(0), view.theme.goal, 2.6);
  } else {
    disc(goal_radius, view.theme.goal, rim, 2.2);
  }
  if (view.is_goal_hot) {
    marks.push_back({Role::goal, std::nullopt,
                     Marker{goal, Shape::disc, view.points(goal_radius + 11.0), rim.with_alpha(0), view.theme.accent,
                            view.points(2.4)}});
  }
  for (const Vector<2>& direction : {Vector<2>(arm, 0.0), Vector<2>(0.0, arm)}) {
    marks.push_back({Role::goal, std::nullopt, Line{goal - direction, goal + direction, view.points(1.8), rim}});
  }
}

}  // namespace ghostforce
