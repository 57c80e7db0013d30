// Marks: everything that a picture of the scene consists of, as values. Positions are in world units [m]; widths,
// radii, lengths and offsets are in points of the screen, so that a picture can be zoomed without its lines growing.
// A list of marks is painted front to back in its order. Painters (GL, vector, JSON) know marks and nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/view/theme.h"
#include "core/conventions.h"
#include "core/strategy.h"

namespace ghostforce {

// What a mark says, for readers of the JSON and for tests.
enum class Role : std::uint8_t {
  wall,
  hatching,
  grid,
  motor_axis,
  trail,
  hand_spring,
  tracking_link,
  goal,
  device,
  proxy,
  contact,
  force,
  ghost_force,
  proxy_drift,
  prediction,
  handle,
  scale,
  legend,
  target,
};
std::string_view role_name(Role role) noexcept;

// The side of a line that its normal points away from.
struct HalfPlane {
  Vector<2> point;
  Vector<2> normal;
  Colour fill;
};

struct Line {
  Vector<2> from;
  Vector<2> to;
  double width;
  Colour colour;
  LinePattern pattern = solid_line;
  double pattern_start = 0.0;  // [m] along the curve that this is a piece of, so that dashes do not crawl
};

struct Marker {
  Vector<2> center;
  Shape shape;
  double radius;
  Colour fill;  // alpha 0: hollow
  Colour rim;
  double rim_width;
  Vector<2> offset{0.0};  // [points], x right, y down
};

struct Arrow {
  Vector<2> tail;
  Vector<2> tip;
  double width;
  Colour fill;
  Colour rim;
  double rim_width;
  Vector<2> offset{0.0};  // [points], x right, y down
};

enum class TextSize : std::uint8_t { small, normal, large };

struct Label {
  Vector<2> anchor;
  Vector<2> offset;  // of the text box's upper left corner [points], x right, y down
  std::string text;
  TextSize size;
  Colour colour;
  Colour halo;  // behind the letters, so that they stand out from lines
};

struct Mark {
  Role role;
  std::optional<StrategyId> strategy;
  std::variant<HalfPlane, Line, Marker, Arrow, Label> form;
  std::optional<Role> about{};  // of an entry of the legend: what it names
};

using Marks = std::vector<Mark>;

// Height of a line of text [points] before the UI scale.
constexpr double text_height(TextSize size) noexcept {
  switch (size) {
    case TextSize::small:
      return 13.0;
    case TextSize::normal:
      return 15.0;
    case TextSize::large:
      return 19.0;
  }
  return 15.0;
}

}  // namespace ghostforce
