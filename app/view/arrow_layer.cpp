#include "app/view/layers.h"
#include "core/wall.h"

namespace ghostforce {
namespace {

constexpr double ghost_aside = 21.0;        // [points]
constexpr double drift_ruler_depth = 16.0;  // of the first ruler inside the wall [points]
constexpr double ruler_step = 12.0;         // between rulers of different strategies [points]

}  // namespace

Vector<2> ghost_arrow_offset(const View& view) {
  const Vector<2> axis = direction_at(view.settings.actuated_angle);
  Vector<2> aside{-axis.y, axis.x};
  if (glm::dot(aside, wall_of(view.settings).normal) < 0.0) aside = -aside;
  return to_screen_direction(aside) * view.points(ghost_aside);
}

bool has_ghost_arrow(const View& view, StrategyId id) {
  return view.options.ghost_forces && is_drawn(view, view.snapshot.strategies[index_of(id)].ghost_force);
}

bool has_drift_ruler(const View& view, StrategyId id) {
  return view.shows(id) && glm::length(view.snapshot.strategies[index_of(id)].proxy_drift) >= smallest_drift;
}

DriftRuler drift_ruler(const View& view, StrategyId id) {
  const Wall<2> wall = wall_of(view.settings);
  const double rank = view.options.compare == Compare::overlay ? static_cast<double>(index_of(id)) : 0.0;
  const Vector<2> inside = -wall.normal * view.metres(drift_ruler_depth + ruler_step * rank);
  const Vector<2> aim = view.snapshot.has_target && view.target ? *view.target : view.snapshot.goal;
  return {projection(wall, aim) + inside, view.snapshot.strategies[index_of(id)].contact + inside};
}

void add_ruler(const View& view, StrategyId id, const DriftRuler& ruler, Marks& marks) {
  const Vector<2> normal = wall_of(view.settings).normal;
  const double tick = view.metres(5.0);
  const auto line = [&](const Vector<2>& from, const Vector<2>& to) {
    marks.push_back({Role::proxy_drift, id, Line{from, to, view.points(2.0), view.theme.strategy[index_of(id)]}});
  };
  line(ruler.from, ruler.to);
  for (const Vector<2>& end : {ruler.from, ruler.to}) line(end - normal * tick, end + normal * tick);
}

void add_arrows(const View& view, StrategyId id, Marks& marks) {
  const std::size_t i = index_of(id);
  const StrategySnapshot<2>& now = view.snapshot.strategies[i];
  const Colour colour = view.theme.strategy[i];
  const double size = view.in_front(id) ? 1.0 : 0.65;
  if (has_drift_ruler(view, id)) add_ruler(view, id, drift_ruler(view, id), marks);
  if (is_drawn(view, now.force)) {
    marks.push_back({Role::force, id,
                     Arrow{now.device, arrow_tip(view, now.device, now.force), view.points(5.0 * size), colour,
                           view.theme.background, view.points(1.2)}});
  }
  // The ghost force is hollow: it is not a force of its own, but a part of the rendered one that should not be there.
  if (has_ghost_arrow(view, id)) {
    marks.push_back({Role::ghost_force, id,
                     Arrow{now.device, arrow_tip(view, now.device, now.ghost_force), view.points(7.5 * size),
                           view.theme.background, colour, view.points(2.0), ghost_arrow_offset(view)}});
  }
}

}  // namespace ghostforce
