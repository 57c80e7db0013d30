// The contact of a handle with a constraint, straight or round. A round wall is one tangent plane for each direction
// from its centre; the one that holds is that in which the proxy lies on its own foot. Pure, never allocates or
// throws, any thread.
//
// How far the proxy lies beside the foot, along the wall, tells the way to it: the energy of contact_solver.h, as a
// function of the direction, grows or falls by the push times that distance. In a ring the energy of the tangent planes
// in which the handle is has one greatest value, and the distance changes its sign there alone; so the search cannot
// miss it, however deep the handle is. Round an obstacle it ends at the face that the last proxy slides to.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "core/contact_solver.h"

namespace ghostforce {

// `hold(planes)`: the contact with those planes.
template <typename Hold>
[[gnu::noinline]] Contact<2> hold_by_round_wall(const RoundWall& wall, const Vector<2>& q, const Vector<2>& last_proxy,
                                                const Hold& hold) noexcept {
  const Vector<2> way = q - wall.center;
  const double distance = glm::length(way);
  Contact<2> contact{q};
  if (wall.is_free_inside ? !(distance > wall.radius) : !(distance < wall.radius)) return contact;
  Vector<2> start = outwards(wall, last_proxy);
  if (wall.is_free_inside && !(glm::dot(start, way) > wall.radius)) start = way / distance;
  const Vector<2> along(-start.y, start.x);
  const auto proxy_beside_foot = [&](double turn) {
    const Vector<2> out = turn == 0.0 ? start : std::cos(turn) * start + std::sin(turn) * along;
    contact = hold(Planes<2>{{tangent_at(wall, out)}, 1});
    const Vector<2> arm = contact.proxy - wall.center;
    return out.x * arm.y - out.y * arm.x;
  };
  const double rounding =
      2.0 * std::numeric_limits<double>::epsilon() * (distance + glm::length(wall.center) + wall.radius);
  constexpr int most_steps = 60;
  constexpr int swift_steps = 8;     // then every other one halves what is left
  constexpr double most_turn = 0.5;  // [rad]
  double turn = 0.0;
  double beside = proxy_beside_foot(turn);
  double slope = -glm::dot(start, way);  // exact where the proxy is tracked alike in all directions
  double least = -std::numeric_limits<double>::infinity();
  double greatest = -least;
  if (wall.is_free_inside && std::abs(beside) > rounding) {
    const double middle = std::atan2(glm::dot(along, way), glm::dot(start, way));
    const double reach = std::acos(wall.radius / distance);
    least = middle - reach;
    greatest = middle + reach;
  }
  for (int step = 0; step < most_steps && std::abs(beside) > rounding; ++step) {
    (beside > 0.0 ? least : greatest) = turn;
    const double wanted = slope < 0.0 ? -beside / slope : std::copysign(most_turn, beside);
    double next = turn + std::clamp(wanted, -most_turn, most_turn);
    if (next == turn) break;
    const bool is_inside = next > least && next < greatest;
    const double middle = 0.5 * (least + greatest);
    if ((!is_inside || (step > swift_steps && step % 2 == 0)) && std::isfinite(middle)) next = middle;
    const double before = beside;
    beside = proxy_beside_foot(next);
    slope = (beside - before) / (next - turn);
    turn = next;
  }
  return contact;
}

template <typename Hold>
Contact<2> hold_by(const Constraint& constraint, const Vector<2>& q, const Vector<2>& last_proxy,
                   const Hold& hold) noexcept {
  if (const auto* const round = std::get_if<RoundWall>(&constraint)) {
    return hold_by_round_wall(*round, q, last_proxy, hold);
  }
  return hold(linearised(constraint, last_proxy));
}

}  // namespace ghostforce
