// The rendered force of the active strategy, and its proxy drift.
#include <algorithm>
#include <cmath>

#include "app/picture/layers.h"
#include "core/scene_shape.h"
#include "core/wall.h"

namespace ghostforce {
namespace {

constexpr double shortest_force = 4.0;  // [points]
constexpr double shortest_ghost = 1.0;
constexpr double ruler_out = 30.0;  // of the ruler from the wall: proxies on it are smaller [points]

}  // namespace

std::optional<DrawnForce> drawn_force(const View& view) {
  const StrategySnapshot<2>& now = view.snapshot.strategies[index_of(view.settings.active)];
  // In free space the sampled loop has a force of its own, which is no wall's.
  if (!now.in_contact) return std::nullopt;
  // Against a target it may be unknown.
  const bool is_known = !std::isnan(now.ghost_force.x) && !std::isnan(now.ghost_force.y);
  const Vector<2> ghost_force = view.options.ghost_forces && is_known ? now.ghost_force : Vector<2>(0.0);
  const Vector<2> share_force = now.force - ghost_force;
  const double share = glm::length(share_force) * view.points_per_newton;
  double ghost = glm::length(ghost_force) * view.points_per_newton;
  if (std::max(share, ghost) < view.points(shortest_force)) return std::nullopt;
  if (ghost < view.points(shortest_ghost)) ghost = 0.0;
  const Vector<2> world = glm::normalize(share >= ghost ? share_force : ghost_force);
  const auto along = [&](const Vector<2>& force, double length) {
    return glm::dot(force, world) < 0.0 ? -length : length;
  };
  return DrawnForce{to_screen(view.camera, now.device), to_screen_direction(world), along(share_force, share),
                    along(ghost_force, ghost)};
}

void add_force(const View& view, Marks& marks) {
  const auto found = drawn_force(view);
  if (!found) return;
  const DrawnForce& force = *found;
  const StrategyId id = view.settings.active;
  const Colour colour = view.theme.strategy[index_of(id)];
  const Colour paper = view.theme.background;
  const double body = view.points(force_arrow_width);
  const double head = 2.185 * body;     // its length, as painters draw it
  const double with_head = head / 0.8;  // the shortest arrow whose head has its full size
  const auto add = [&](bool is_ghost, const Vector<2>& from, const Vector<2>& to, bool has_head) {
    marks.push_back(
        {is_ghost ? Role::ghost_force : Role::force, id,
         Arrow{to_world(view.camera, from), to_world(view.camera, to), body, is_ghost ? paper : colour,
               is_ghost ? colour : paper, view.points(is_ghost ? 1.8 : 1.2), Vector<2>(0.0), has_head, is_ghost}});
  };
  if (force.ghost == 0.0) {
    add(false, force.start, force.tip(), true);
  } else if (force.ghost > 0.0 && force.share >= 0.0) {
    // One head for both, and it is the ghost's.
    const double length = std::min(std::max(force.ghost, with_head), force.share + force.ghost);
    // The bar ends where the head begins, which is narrower at its tip.
    const double neck = force.share + force.ghost - head * std::min(1.0, length / with_head);
    const double bar = std::min(force.share, neck);
    if (bar > 0.0) add(false, force.start, force.start + force.direction * bar, false);
    add(true, force.tip() - force.direction * length, force.tip(), true);
  } else {
    // Too little: it folds back over the share.
    if (force.share != 0.0) add(false, force.start, force.share_end(), true);
    add(true, force.share_end(), force.tip(), true);
  }
}

std::optional<Ruler> drift_ruler(const View& view) {
  const StrategySnapshot<2>& now = view.snapshot.strategies[index_of(view.settings.active)];
  if (!(glm::length(now.proxy_drift) >= smallest_drift)) return std::nullopt;  // NaN: it is unknown
  const Vector<2> aim = view.snapshot.has_target && view.target ? *view.target : view.snapshot.goal;
  const Wall<2> wall = wall_near(view.settings, now.contact);
  const Vector<2> aside = wall.normal * view.metres(ruler_out);
  return Ruler{foot_on_edge(view.settings, aim) + aside, foot_on_edge(view.settings, now.contact) + aside, aim,
               now.contact};
}

// As a drawing has it: thin lines lead from what is measured to the ends of the ruler, and a little beyond.
void add_drift(const View& view, Marks& marks) {
  const auto found = drift_ruler(view);
  if (!found) return;
  const Ruler& ruler = *found;
  const StrategyId id = view.settings.active;
  const Colour colour = view.theme.strategy[index_of(id)];
  const Vector<2> normal = wall_near(view.settings, view.snapshot.strategies[index_of(id)].contact).normal;
  const Vector<2> tick = normal * view.metres(5.0);
  const auto line = [&](const Vector<2>& from, const Vector<2>& to, double width) {
    marks.push_back({Role::proxy_drift, id, Line{from, to, view.points(width), colour}});
  };
  line(ruler.from, ruler.to, 2.4);
  line(ruler.from - tick, ruler.from + tick, 2.4);
  line(ruler.to - tick, ruler.to + tick, 2.4);
  line(ruler.foot, ruler.from, 1.0);
  line(ruler.other, ruler.to, 1.0);
}

}  // namespace ghostforce
