// Upright rectangles on the screen (y down, points), and what of a line lies in one: for those who place words beside
// lines. Pure, any thread.
#pragma once

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/conventions.h"

namespace ghostforce {

struct ScreenBox {
  Vector<2> least{0.0};
  Vector<2> most{0.0};

  Vector<2> extent() const noexcept { return most - least; }
  void include(const Vector<2>& point) noexcept {
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
  ScreenBox grown(double by) const noexcept { return grown(Vector<2>(by)); }
  ScreenBox grown(const Vector<2>& by) const noexcept { return {least - by, most + by}; }
};

// The area that both cover.
inline double overlap(const ScreenBox& a, const ScreenBox& b) noexcept {
  const double width = std::min(a.most.x, b.most.x) - std::max(a.least.x, b.least.x);
  const double height = std::min(a.most.y, b.most.y) - std::max(a.least.y, b.least.y);
  return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

// Edges belong to it; a NaN lies in no box.
inline bool contains(const ScreenBox& box, const Vector<2>& point) noexcept {
  return point.x >= box.least.x && point.x <= box.most.x && point.y >= box.least.y && point.y <= box.most.y;
}

struct ScreenPiece {
  Vector<2> from{0.0};
  Vector<2> to{0.0};
  double start = 0.0;  // along the curve that it is a piece of
};

// Leaves what of a piece lies in the box; false where nothing does. Liang and Barsky's way.
inline bool clip(const ScreenBox& box, ScreenPiece& piece) noexcept {
  const Vector<2> way = piece.to - piece.from;
  double first = 0.0;
  double last = 1.0;
  for (const glm::length_t axis : {0, 1}) {
    const double to_least = box.least[axis] - piece.from[axis];
    const double to_most = box.most[axis] - piece.from[axis];
    if (way[axis] == 0.0) {
      if (to_least > 0.0 || to_most < 0.0) return false;
    } else {
      first = std::max(first, std::min(to_least / way[axis], to_most / way[axis]));
      last = std::min(last, std::max(to_least / way[axis], to_most / way[axis]));
    }
  }
  if (first > last) return false;
  const Vector<2> from = piece.from;
  // Ends that need not move stay the same numbers: painters join pieces where they are equal.
  if (last < 1.0) piece.to = from + last * way;
  if (first > 0.0) piece.from = from + first * way;
  piece.start += first * glm::length(way);
  return true;
}

}  // namespace ghostforce
