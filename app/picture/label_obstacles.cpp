#include "app/picture/label_obstacles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace ghostforce {
namespace {

std::array<Vector<2>, 4> corners_of(const ScreenBox& box) {
  return {box.least, {box.most.x, box.least.y}, box.most, {box.least.x, box.most.y}};
}

double distance_to_box(const ScreenBox& box, const Vector<2>& from, const Vector<2>& to) {
  ScreenPiece piece{from, to, 0.0};
  if (clip(box, piece)) return 0.0;
  double least = std::min(glm::distance(from, glm::clamp(from, box.least, box.most)),
                          glm::distance(to, glm::clamp(to, box.least, box.most)));
  for (const Vector<2>& corner : corners_of(box)) least = std::min(least, distance_to_line(corner, from, to));
  return least;
}

struct Interval {
  double least;
  double most;
};

// Where the left edge of a block in the row from `top` on must not be: nowhere, if it is empty.
std::optional<Interval> taken_by(const Vector<2>& from, const Vector<2>& to, double radius, double top,
                                 const Vector<2>& extent) {
  constexpr double far = 1e9;
  const ScreenBox row{{-far, top - radius}, {far, top + extent.y + radius}};
  ScreenPiece piece{from, to, 0.0};
  if (!clip(row, piece)) return std::nullopt;
  double reach = radius;
  if (from == to) {
    const double below = std::max({top - from.y, from.y - top - extent.y, 0.0});
    reach = std::sqrt(std::max(0.0, radius * radius - below * below));
  }
  return Interval{std::min(piece.from.x, piece.to.x) - extent.x - reach, std::max(piece.from.x, piece.to.x) + reach};
}

// The corner of the box that lies farthest to the left, looking along.
double leftmost(const ScreenPiece& edge, const ScreenBox& box) {
  const Vector<2> along = edge.to - edge.from;
  const double length = glm::length(along);
  double most = -std::numeric_limits<double>::infinity();
  for (const Vector<2>& corner : corners_of(box)) {
    const Vector<2> way = corner - edge.from;
    // Screens have y down: left is where this is positive.
    most = std::max(most, (along.y * way.x - along.x * way.y) / length);
  }
  return most;
}

// Leaves of the row's room what lies to the right of the edge. `leftmost()` grows evenly with the box's place.
void keep_right_of(const ScreenPiece& edge, double air, double top, const Vector<2>& extent, Interval& room) {
  const auto over = [&](double x) { return leftmost(edge, {{x, top}, Vector<2>(x, top) + extent}) + air; };
  const double at_least = over(room.least);
  const double at_most = over(room.most);
  if (at_least > 0.0 && at_most > 0.0) {
    room.most = room.least - 1.0;
  } else if (at_least > 0.0) {
    room.least += (room.most - room.least) * at_least / (at_least - at_most);
  } else if (at_most > 0.0) {
    room.most -= (room.most - room.least) * at_most / (at_most - at_least);
  }
}

// The number in the room that is nearest to the wanted one and not taken.
std::optional<double> nearest_in(const Interval& room, std::vector<Interval>& taken, double wanted) {
  if (room.least > room.most) return std::nullopt;
  std::ranges::sort(taken, {}, &Interval::least);
  std::optional<double> nearest;
  const auto offer = [&](double from, double to) {
    if (from > to) return;
    const double place = std::clamp(wanted, from, to);
    if (!nearest || std::abs(place - wanted) < std::abs(*nearest - wanted)) nearest = place;
  };
  double free_from = room.least;
  for (const Interval& interval : taken) {
    offer(free_from, std::min(interval.least, room.most));
    free_from = std::max(free_from, interval.most);
  }
  offer(free_from, room.most);
  return nearest;
}

}  // namespace

double distance_to_line(const Vector<2>& point, const Vector<2>& from, const Vector<2>& to) noexcept {
  const Vector<2> way = to - from;
  const double length = glm::dot(way, way);
  const double share = length > 0.0 ? std::clamp(glm::dot(point - from, way) / length, 0.0, 1.0) : 0.0;
  return glm::distance(point, from + share * way);
}

double distance_between_lines(const ScreenPiece& a, const ScreenPiece& b) noexcept {
  const auto side = [](const ScreenPiece& piece, const Vector<2>& point) {
    const Vector<2> along = piece.to - piece.from;
    const Vector<2> way = point - piece.from;
    return along.x * way.y - along.y * way.x;
  };
  if (side(a, b.from) * side(a, b.to) < 0.0 && side(b, a.from) * side(b, a.to) < 0.0) return 0.0;
  return std::min({distance_to_line(a.from, b.from, b.to), distance_to_line(a.to, b.from, b.to),
                   distance_to_line(b.from, a.from, a.to), distance_to_line(b.to, a.from, a.to)});
}

std::uint64_t LabelObstacles::signature() const noexcept {
  std::uint64_t mixed = 0;
  const auto add = [&](double number) {
    mixed = (mixed ^ std::bit_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15ULL;
    mixed ^= mixed >> 29;
  };
  const auto add_point = [&](const Vector<2>& point) {
    add(point.x);
    add(point.y);
  };
  for (const ThickLine& line : lines_) {
    add_point(line.from);
    add_point(line.to);
    add(line.radius);
  }
  for (const ScreenBox& box : boxes_) {
    add_point(box.least);
    add_point(box.most);
  }
  return mixed;
}

bool LabelObstacles::is_free(const ScreenBox& box, double air, Clearance clearance) const {
  const ScreenBox airy = box.grown(air);
  for (const ScreenBox& other : boxes_) {
    if (overlap(airy, other) > 0.0) return false;
  }
  return std::ranges::none_of(lines_, [&](const ThickLine& line) { return is_near(line, box, air, clearance); });
}

bool LabelObstacles::is_crossed(const ScreenBox& box, Clearance clearance) const {
  return std::ranges::any_of(lines_, [&](const ThickLine& line) { return is_near(line, box, 0.0, clearance); });
}

bool LabelObstacles::is_near(const ThickLine& line, const ScreenBox& box, double air, Clearance clearance) {
  if (clearance == Clearance::if_possible && line.clearance == Clearance::if_possible) return false;
  const double reach = line.radius + air;
  const ScreenBox grown = box.grown(reach);
  if (std::max(line.from.x, line.to.x) <= grown.least.x || std::min(line.from.x, line.to.x) >= grown.most.x ||
      std::max(line.from.y, line.to.y) <= grown.least.y || std::min(line.from.y, line.to.y) >= grown.most.y) {
    return false;
  }
  return distance_to_box(box, line.from, line.to) < reach;
}

bool LabelObstacles::can_pass(const Vector<2>& from, const Vector<2>& to) const {
  for (const ScreenBox& box : boxes_) {
    ScreenPiece piece{from, to, 0.0};
    if (clip(box, piece)) return false;
  }
  const ScreenPiece way{from, to, 0.0};
  return std::ranges::none_of(lines_, [&](const ThickLine& line) {
    if (line.clearance == Clearance::if_possible) return false;
    // It may begin at a rim.
    return distance_between_lines(way, {line.from, line.to, 0.0}) < 0.98 * line.radius;
  });
}

std::optional<Vector<2>> LabelObstacles::find_block(const BlockRequest& request, double row_height) const {
  const Vector<2>& extent = request.extent;
  const double lowest = request.region.most.y - extent.y;
  std::optional<Vector<2>> best;
  double least_cost = std::numeric_limits<double>::infinity();
  std::vector<Interval> taken;
  const auto try_row = [&](double top) {
    const double down = std::abs(top - request.wanted.y);
    if (down >= least_cost) return;
    Interval room{request.region.least.x, request.region.most.x - extent.x};
    if (room.least > room.most) return;
    if (request.edge) keep_right_of(*request.edge, request.air, top, extent, room);
    taken.clear();
    for (const ScreenBox& box : boxes_) {
      const ScreenBox airy = box.grown(request.air_to_boxes);
      if (airy.most.y > top && airy.least.y < top + extent.y) taken.push_back({airy.least.x - extent.x, airy.most.x});
    }
    for (const ThickLine& line : lines_) {
      if (request.clearance == Clearance::if_possible && line.clearance == Clearance::if_possible) continue;
      if (const auto found = taken_by(line.from, line.to, line.radius + request.air, top, extent)) {
        taken.push_back(*found);
      }
    }
    const auto across = nearest_in(room, taken, request.wanted.x);
    if (!across) return;
    const double cost = down + std::abs(*across - request.wanted.x);
    if (cost >= least_cost) return;
    least_cost = cost;
    best = Vector<2>(*across, top);
  };
  if (lowest < request.region.least.y) return std::nullopt;
  try_row(std::clamp(request.wanted.y, request.region.least.y, lowest));
  for (double top = request.region.least.y; top <= lowest; top += row_height) try_row(top);
  try_row(lowest);
  return best;
}

bool lies_right_of(const ScreenPiece& edge, const ScreenBox& box, double air) noexcept {
  return leftmost(edge, box) + air <= 0.0;
}

}  // namespace ghostforce
