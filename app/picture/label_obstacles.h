// LabelObstacles: what words must not cover, and where there is room beside it. Points of the window, y
// down. Values; one thread.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/picture/screen_box.h"

namespace ghostforce {

// Long and thin, so that a large block may stand upon it where it finds no other place: rails, edges, dotted lines.
enum class Clearance : std::uint8_t { always, if_possible };

class LabelObstacles {
 public:
  // A thick line with round ends, or a rectangle.
  void add(const Vector<2>& from, const Vector<2>& to, double radius, Clearance clearance) {
    lines_.push_back({from, to, radius, clearance});
  }
  void add(const ScreenBox& box) { boxes_.push_back(box); }

  // Two with the same number have the same in them, most likely.
  std::uint64_t signature() const noexcept;

  // Whether a box has so much air to all of them.
  bool is_free(const ScreenBox& box, double air, Clearance clearance) const;
  // Whether a line runs through a box; with if_possible, one that is not long and thin.
  bool is_crossed(const ScreenBox& box, Clearance clearance) const;
  // Whether a thin line crosses none but the long and thin ones.
  bool can_pass(const Vector<2>& from, const Vector<2>& to) const;

  struct BlockRequest {
    Vector<2> extent;
    ScreenBox region;                   // that it must lie in
    Vector<2> wanted;                   // its upper left corner, best of all
    std::optional<ScreenPiece> edge{};  // it must lie to the right of this, looking along it
    double air = 0.0;                   // to lines,
    double air_to_boxes = 0.0;          // and to boxes
    Clearance clearance = Clearance::always;
  };
  // The upper left corner of the best free place.
  std::optional<Vector<2>> find_block(const BlockRequest& request, double row_height) const;

 private:
  struct ThickLine {
    Vector<2> from;
    Vector<2> to;
    double radius;
    Clearance clearance;
  };
  static bool is_near(const ThickLine& line, const ScreenBox& box, double air, Clearance clearance);

  std::vector<ThickLine> lines_;
  std::vector<ScreenBox> boxes_;
};

// Of a point from all of a line.
double distance_to_line(const Vector<2>& point, const Vector<2>& from, const Vector<2>& to) noexcept;
double distance_between_lines(const ScreenPiece& a, const ScreenPiece& b) noexcept;

// Whether a box lies to the right of a line, looking along it, and so far from it.
bool lies_right_of(const ScreenPiece& edge, const ScreenBox& box, double air) noexcept;

}  // namespace ghostforce
