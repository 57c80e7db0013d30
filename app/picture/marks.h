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

#include "app/picture/theme.h"
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
  hand,
  wall_share,
  expected_rest,
  expected_contact,
  guess,
  area,
  map,
  linkage,
  joint,
  reach,
  sentence,
  number,
  button,
  hint,
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
  Vector<2> offset{0.0};    // [points], x right, y down
  bool has_head = true;     // without: a bar, cut straight at both ends
  bool is_hatched = false;  // stripes of the rim's colour over the fill, across the arrow's axis at 45°
};

// An upright rectangle with round corners.
struct Box {
  Vector<2> corner;  // upper left
  Vector<2> size;    // [points], x right, y down
  double radius;     // of its corners [points]
  Colour fill;       // alpha 0: hollow
  Colour rim;
  double rim_width;
  Vector<2> offset{0.0};  // of the corner [points], x right, y down
};

// The inside of a closed curve; where the curve crosses itself, what it encloses an odd number of times.
struct Area {
  std::vector<Vector<2>> corners;
  Colour fill;
};

// A picture of cells over an upright rectangle, smooth between their middles.
struct Raster {
  Vector<2> corner;  // upper left
  Vector<2> size;    // [points], x right, y down
  int columns;
  int rows;
  std::vector<Colour> cells;  // row by row from the upper left, opaque
};

struct TextStyle {
  double height;  // of a line of text, from the highest to the lowest letter [points]
  bool is_bold = false;

  friend constexpr bool operator==(const TextStyle&, const TextStyle&) noexcept = default;
};
// The letters of the workbench's scene, before the UI scale.
inline constexpr TextStyle small_text{13.0};
inline constexpr TextStyle normal_text{15.0};
inline constexpr TextStyle large_text{19.0};

struct Label {
  Vector<2> anchor;
  Vector<2> offset;  // of the text box's upper left corner [points], x right, y down
  std::string text;
  TextStyle style;  // its height before the UI scale
  Colour colour;
  Colour halo;  // behind the letters, so that they stand out from lines
};

struct Mark {
  Role role;
  std::optional<StrategyId> strategy;
  std::variant<HalfPlane, Line, Marker, Arrow, Box, Area, Raster, Label> form;
  std::optional<Role> about{};  // of an entry of the legend: what it names
};

using Marks = std::vector<Mark>;

// From stripe to stripe of a hatched arrow, in widths of the arrow; all painters draw it alike.
inline constexpr double stripe_step = 0.53;

}  // namespace ghostforce
