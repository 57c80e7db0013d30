#include "app/picture/layers.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double proxy_radius = 7.6;  // [points]
constexpr double goal_radius = 10.5;
constexpr double pale_size = 0.72;  // of the strategies that are not active,
constexpr double pale_share = 0.5;  // and of their colour

void add_pale(const View& view, StrategyId id, Marks& marks) {
  const StrategySnapshot<2>& now = view.snapshot.strategies[index_of(id)];
  const Shape shape = strategy_style(id).shape;
  const Colour paper = view.theme.background;
  const Colour colour = pale_colour(view.theme, id);
  if (now.in_contact) {
    marks.push_back({Role::proxy, id,
                     Marker{now.proxy, shape, view.points(pale_size * proxy_radius), paper, colour, view.points(1.6)}});
  }
  const bool is_hollow = view.is_predicted(id);
  marks.push_back({Role::device, id,
                   Marker{now.device, shape, view.points(pale_size * device_radius), is_hollow ? paper : colour,
                          is_hollow ? colour : paper, view.points(1.4)}});
}

}  // namespace

Colour pale_colour(const Theme& theme, StrategyId id) noexcept {
  return mix(theme.background, theme.strategy[index_of(id)], pale_share);
}

double reach_of(Shape shape) noexcept {
  switch (shape) {
    case Shape::disc:
      return 1.0;
    case Shape::diamond:
      return 1.3;
    case Shape::triangle:
      return 1.57;
  }
  return 1.0;
}

void add_hand(const View& view, Marks& marks) {
  const Vector<2> device = view.snapshot.strategies[index_of(view.settings.active)].device;
  const LinePattern dots{view.points(2.0), view.points(5.0), view.points(2.0), view.points(5.0)};
  marks.push_back({Role::hand_spring, std::nullopt,
                   Line{view.snapshot.goal, device, view.points(2.0), view.theme.faint_text, dots}});
}

void add_others(const View& view, Marks& marks) {
  for_each_shown(view, [&](StrategyId id) {
    if (!view.in_front(id)) add_pale(view, id, marks);
  });
}

void add_proxy(const View& view, Marks& marks) {
  const StrategyId id = view.settings.active;
  const StrategySnapshot<2>& now = view.snapshot.strategies[index_of(id)];
  if (!now.in_contact) return;  // in free space the proxy is the device
  const Colour colour = view.theme.strategy[index_of(id)];
  const Vector<2> tick = wall_near(view.settings, now.contact).normal * view.metres(7.0);
  marks.push_back(
      {Role::tracking_link, id, Line{now.device, now.proxy, view.points(1.4), mix(view.theme.wall, colour, 0.7)}});
  marks.push_back({Role::contact, id, Line{now.contact - tick, now.contact + tick, view.points(2.2), colour}});
  marks.push_back({Role::proxy, id,
                   Marker{now.proxy, strategy_style(id).shape, view.points(proxy_radius), view.theme.background, colour,
                          view.points(2.2)}});
}

// Filled: the device itself; measured, it has an eye. Hollow: it is only simulated beside a measured one.
void add_device(const View& view, Marks& marks) {
  const StrategyId id = view.settings.active;
  const Vector<2> at = view.snapshot.strategies[index_of(id)].device;
  const Shape shape = strategy_style(id).shape;
  const Colour colour = view.theme.strategy[index_of(id)];
  const Colour paper = view.theme.background;
  if (view.is_predicted(id)) {
    marks.push_back(
        {Role::device, id,
         Marker{at, shape, view.points(0.9 * device_radius), paper.with_alpha(150), colour, view.points(1.6)}});
    return;
  }
  marks.push_back({Role::device, id, Marker{at, shape, view.points(device_radius), colour, paper, view.points(1.6)}});
  if (view.snapshot.measured == id) {
    marks.push_back(
        {Role::device, id, Marker{at, Shape::disc, view.points(0.3 * device_radius), paper, colour, view.points(0.5)}});
  }
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

void add_goal_in_device(const View& view, Marks& marks) {
  constexpr double dot_radius = 4.5;
  const Vector<2> device = view.snapshot.strategies[index_of(view.settings.active)].device;
  const bool is_covered = glm::distance(device, view.snapshot.goal) < view.metres(device_radius);
  if (view.snapshot.measured || !is_covered) return;
  marks.push_back({Role::goal, std::nullopt,
                   Marker{view.snapshot.goal, Shape::disc, view.points(dot_radius), view.theme.goal,
                          view.theme.goal_rim, view.points(1.6)}});
}

// The loop that the active device went round on the last turn of the circle test, filled: what it encloses is what the
// energy of the turn is about.
void add_loop(const View& view, Marks& marks) {
  if (!view.turn_s) return;
  const StrategyId id = view.settings.active;
  std::vector<Vector<2>> loop = last_loop(view.history.moments(), id, *view.turn_s);
  if (loop.size() < 3) return;
  const Colour colour = view.theme.strategy[index_of(id)];
  for (std::size_t i = 1; i < loop.size(); ++i) {
    marks.push_back({Role::area, id, Line{loop[i - 1], loop[i], view.points(1.6), colour}});
  }
  marks.push_back({Role::area, id, Area{std::move(loop), colour.with_alpha(60)}});
}

namespace {

constexpr double target_radius = 12.0;  // [points]
constexpr double line_length = 60.0;    // into the wall [points]

}  // namespace

// What the hand at a device is told to aim at: a target on the wall, and the line straight into the wall at it.
void add_target(const View& view, Marks& marks) {
  if (!view.target) return;
  const Vector<2> inwards = -wall_near(view.settings, *view.target).normal;
  const Vector<2> target = *view.target;
  const LinePattern dashes{view.points(7.0), view.points(4.0), view.points(7.0), view.points(4.0)};
  marks.push_back(
      {Role::target, std::nullopt,
       Line{target, target + inwards * view.metres(line_length), view.points(1.8), view.theme.text, dashes}});
  for (const double radius : {target_radius, 0.45 * target_radius}) {
    marks.push_back({Role::target, std::nullopt,
                     Marker{target, Shape::disc, view.points(radius), view.theme.background.with_alpha(0),
                            view.theme.text, view.points(2.4)}});
  }
}

namespace {

constexpr double device_ring = 15.5;  // around the device's marker [points]
constexpr double proxy_ring = 13.0;

}  // namespace

// Thin rings where the closed form puts proxy and device at rest: the simulation has to come to them by itself.
void add_predictions(const View& view, Marks& marks) {
  const StrategyId id = view.settings.active;
  const auto rest = rest_of(id, view.settings, view.snapshot.goal);
  if (!rest) return;
  const Colour colour = view.theme.strategy[index_of(id)];
  const auto ring = [&](const Vector<2>& center, double radius) {
    marks.push_back({Role::prediction, id,
                     Marker{center, Shape::disc, view.points(radius), colour.with_alpha(0), colour, view.points(1.0)}});
  };
  ring(rest->at.device, device_ring);
  if (rest->at.in_contact) ring(rest->at.proxy, proxy_ring);
}

}  // namespace ghostforce
