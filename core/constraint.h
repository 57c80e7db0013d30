// What holds the proxy of a general scene: a wall, a corner of two walls, or a round wall. A constraint is seen as the
// planes that it has near the proxy; each of them is a Wall. Pure values and functions, never allocate or throw, any
// thread.
#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include <glm/geometric.hpp>

#include "core/conventions.h"
#include "core/wall.h"

namespace ghostforce {

// Two walls through one point. What lies in front of both is free: less than a half-plane.
struct CornerWall {
  Vector<2> point{0.0};              // [m]
  std::array<Vector<2>, 2> normals;  // outward unit normals [1]
};

// The edge of a disc. Free is the disc, as in a ring, or everything but the disc, as round an obstacle.
struct RoundWall {
  Vector<2> center{0.0};  // [m]
  double radius = 0.0;    // [m]
  bool is_free_inside = true;
};

using Constraint = std::variant<Wall<2>, CornerWall, RoundWall>;

inline constexpr std::size_t most_planes = 2;

// The half-spaces that stand for a constraint near a proxy. The signed distance of each is a true distance.
template <glm::length_t D>
struct Planes {
  std::array<Wall<D>, most_planes> walls;
  std::size_t count = 0;
};

// The direction from its centre to q; from the centre itself any one is as good.
inline Vector<2> outwards(const RoundWall& wall, const Vector<2>& q) noexcept {
  const Vector<2> way = q - wall.center;
  const double distance = glm::length(way);
  return distance > 0.0 ? way / distance : Vector<2>(1.0, 0.0);
}

// Where its edge lies in that direction from the centre, a unit vector.
inline Wall<2> tangent_at(const RoundWall& wall, const Vector<2>& out) noexcept {
  return {wall.center + wall.radius * out, wall.is_free_inside ? -out : out};
}

// A round wall is the tangent plane at the point of its edge that is nearest to the last proxy; round_contact.h says
// which of its planes holds a handle.
Planes<2> linearised(const Constraint& constraint, const Vector<2>& last_proxy) noexcept;

// Whether that depends on the proxy.
inline bool is_curved(const Constraint& constraint) noexcept {
  return std::holds_alternative<RoundWall>(constraint);
}

// Positive on the free side, negative inside [m]. In a corner that of the wall in which q is deepest.
double signed_distance(const Constraint& constraint, const Vector<2>& q) noexcept;

// The nearest point of the edge [m].
Vector<2> projection(const Constraint& constraint, const Vector<2>& q) noexcept;

// The edge as points of a line, for drawing: as far as `reach` from its middle [m], and closed where the edge is.
struct Outline {
  static constexpr std::size_t most_points = 97;
  std::array<Vector<2>, most_points> points;
  std::size_t count = 0;
  bool is_closed = false;
};
Outline outline(const Constraint& constraint, double reach) noexcept;

}  // namespace ghostforce
