// The wall: the constraint, linearised, as a half-space of free motion. Pure values and functions, any thread.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>

#include "core/conventions.h"

namespace ghostforce {

template <glm::length_t D>
struct Wall {
  Vector<D> point;   // o, any point on the wall [m]
  Vector<D> normal;  // n, outward unit normal [1]
};

// n·(q − o) [m]: positive on the free side, negative inside the wall.
template <glm::length_t D>
double signed_distance(const Wall<D>& wall, const Vector<D>& q) noexcept {
  return glm::dot(wall.normal, q - wall.point);
}

// d = n·(o − q) [m], positive inside; with q the goal this is (8).
template <glm::length_t D>
double depth(const Wall<D>& wall, const Vector<D>& q) noexcept {
  return -signed_distance(wall, q);
}

// (3)  q_c = q_p + n n·(o − q_p) [m]: the nearest point of the wall.
template <glm::length_t D>
Vector<D> projection(const Wall<D>& wall, const Vector<D>& q) noexcept {
  return q + wall.normal * depth(wall, q);
}

// The part of a vector that lies along the wall: v − n (n·v).
template <glm::length_t D>
Vector<D> along(const Wall<D>& wall, const Vector<D>& v) noexcept {
  return v - wall.normal * glm::dot(wall.normal, v);
}

// Unit vector at an angle [rad], counter-clockwise from +x.
inline Vector<2> direction_at(double angle_rad) noexcept {
  return {std::cos(angle_rad), std::sin(angle_rad)};
}

}  // namespace ghostforce
