#include "core/constraint.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace ghostforce {
namespace {

Wall<2> wall_of(const CornerWall& corner, std::size_t which) noexcept {
  return {corner.point, corner.normals[which]};
}

// Along the wall, to where the other one is not in the way.
Vector<2> edge_direction(const CornerWall& corner, std::size_t which) noexcept {
  const Vector<2>& normal = corner.normals[which];
  const Vector<2> along(-normal.y, normal.x);
  return glm::dot(along, corner.normals[1 - which]) > 0.0 ? along : -along;
}

struct LinearisedAt {
  const Vector<2>& proxy;
  Planes<2> operator()(const Wall<2>& wall) const noexcept { return {{wall}, 1}; }
  Planes<2> operator()(const CornerWall& corner) const noexcept {
    return {{wall_of(corner, 0), wall_of(corner, 1)}, 2};
  }
  Planes<2> operator()(const RoundWall& wall) const noexcept { return {{tangent_at(wall, outwards(wall, proxy))}, 1}; }
};

struct ProjectionOf {
  const Vector<2>& q;
  Vector<2> operator()(const Wall<2>& wall) const noexcept { return ghostforce::projection(wall, q); }
  Vector<2> operator()(const CornerWall& corner) const noexcept {
    Vector<2> nearest = corner.point;
    for (std::size_t i = 0; i < 2; ++i) {
      const Vector<2> along = edge_direction(corner, i);
      const Vector<2> foot = corner.point + along * std::fmax(0.0, glm::dot(along, q - corner.point));
      if (glm::length(foot - q) < glm::length(nearest - q)) nearest = foot;
    }
    return nearest;
  }
  Vector<2> operator()(const RoundWall& wall) const noexcept { return wall.center + wall.radius * outwards(wall, q); }
};

void add(const Vector<2>& point, Outline& outline) noexcept {
  outline.points[outline.count++] = point;
}

struct OutlineOf {
  double reach;
  Outline operator()(const Wall<2>& wall) const noexcept {
    const Vector<2> along(-wall.normal.y, wall.normal.x);
    Outline edge;
    add(wall.point - reach * along, edge);
    add(wall.point + reach * along, edge);
    return edge;
  }
  Outline operator()(const CornerWall& corner) const noexcept {
    Outline edge;
    add(corner.point + reach * edge_direction(corner, 0), edge);
    add(corner.point, edge);
    add(corner.point + reach * edge_direction(corner, 1), edge);
    return edge;
  }
  Outline operator()(const RoundWall& wall) const noexcept {
    Outline edge;
    edge.is_closed = true;
    for (std::size_t i = 0; i + 1 < Outline::most_points; ++i) {
      const double turn = static_cast<double>(i) / static_cast<double>(Outline::most_points - 1);
      add(wall.center + wall.radius * direction_at(2.0 * std::numbers::pi * turn), edge);
    }
    return edge;
  }
};

struct DistanceOf {
  const Vector<2>& q;
  double operator()(const Wall<2>& wall) const noexcept { return ghostforce::signed_distance(wall, q); }
  double operator()(const CornerWall& corner) const noexcept {
    return std::fmin(ghostforce::signed_distance(wall_of(corner, 0), q),
                     ghostforce::signed_distance(wall_of(corner, 1), q));
  }
  double operator()(const RoundWall& wall) const noexcept {
    const double inside = wall.radius - glm::length(q - wall.center);
    return wall.is_free_inside ? inside : -inside;
  }
};

}  // namespace

Planes<2> linearised(const Constraint& constraint, const Vector<2>& last_proxy) noexcept {
  return std::visit(LinearisedAt{last_proxy}, constraint);
}

double signed_distance(const Constraint& constraint, const Vector<2>& q) noexcept {
  return std::visit(DistanceOf{q}, constraint);
}

Vector<2> projection(const Constraint& constraint, const Vector<2>& q) noexcept {
  return std::visit(ProjectionOf{q}, constraint);
}

Outline outline(const Constraint& constraint, double reach) noexcept {
  return std::visit(OutlineOf{reach}, constraint);
}

}  // namespace ghostforce
