#include "app/stage/landscape_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "app/picture/share_colour.h"

namespace ghostforce {
namespace {

constexpr int map_columns = 120;
constexpr int map_rows = 80;

// ---- Contours -------------------------------------------------------------------------------------------------------

double distance_to_piece(const Vector<2>& point, const Vector<2>& from, const Vector<2>& to) noexcept {
  const Vector<2> way = to - from;
  const double length_squared = glm::dot(way, way);
  const double share = length_squared > 0.0 ? std::clamp(glm::dot(point - from, way) / length_squared, 0.0, 1.0) : 0.0;
  return glm::distance(point, from + share * way);
}

// Douglas and Peucker: drops every corner that lies so near to the line without it.
std::vector<Vector<2>> without_idle_corners(const std::vector<Vector<2>>& corners, double nearest) {
  std::vector<bool> is_kept(corners.size(), false);
  is_kept.front() = is_kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, corners.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double greatest = nearest;
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distance_to_piece(corners[i], corners[first], corners[last]);
      if (distance > greatest) greatest = distance, farthest = i;
    }
    if (farthest == first) continue;
    is_kept[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  std::vector<Vector<2>> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (is_kept[i]) kept.push_back(corners[i]);
  }
  return kept;
}

// What of a line lies in the box, as lines of their own.
std::vector<std::vector<Vector<2>>> pieces_inside(const ScreenBox& box, const std::vector<Vector<2>>& corners) {
  std::vector<std::vector<Vector<2>>> pieces;
  bool goes_on = false;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    ScreenPiece piece{corners[i - 1], corners[i]};
    const bool is_inside = clip(box, piece);
    if (is_inside && !goes_on) pieces.push_back({piece.from});
    if (is_inside) pieces.back().push_back(piece.to);
    goes_on = is_inside && piece.to == corners[i];
  }
  return pieces;
}

double contour_width(const LandscapeLayout& layout) noexcept {
  return 0.07 * layout.em;
}

// ---- Their labels ---------------------------------------------------------------------------------------------------

bool is_crossed(const ScreenBox& box, const std::vector<DrawnContour>& contours, double but_level) {
  for (const DrawnContour& contour : contours) {
    if (contour.level == but_level) continue;
    for (std::size_t i = 1; i < contour.corners.size(); ++i) {
      ScreenPiece piece{contour.corners[i - 1], contour.corners[i]};
      if (clip(box, piece)) return true;
    }
  }
  return false;
}

// A point of the contour on each line of text from the map's top downwards.
std::vector<Vector<2>> places_along(const DrawnContour& contour, const LandscapeLayout& layout) {
  std::vector<Vector<2>> places;
  const double step = 0.6 * line_height * layout.em;
  for (double y = layout.map.least.y + step; y < layout.map.most.y; y += step) {
    for (std::size_t i = 1; i < contour.corners.size(); ++i) {
      const Vector<2>& from = contour.corners[i - 1];
      const Vector<2>& to = contour.corners[i];
      if ((from.y <= y) == (to.y <= y)) continue;
      places.push_back(from + (to - from) * ((y - from.y) / (to.y - from.y)));
    }
  }
  return places;
}

// Upon its line, which its halo breaks: between two lines one would not know to which of them it belongs. The first
// place from the top that is free and that no other line crosses; false where there is none.
bool add_contour_label(const LandscapeView& view, const LandscapeLayout& layout, const DrawnContour& contour,
                       const std::vector<DrawnContour>& contours, LandscapeWords& words) {
  const TextStyle drawn = words.style(1.0);
  const std::string text = share_words(contour.level);
  const Vector<2> extent = words.extent(text, drawn);
  const ScreenBox inside = layout.map.grown(-0.15 * layout.em);
  for (const Vector<2>& place : places_along(contour, layout)) {
    const ScreenBox box{place - 0.5 * extent, place + 0.5 * extent};
    if (!contains(inside, box.least) || !contains(inside, box.most)) continue;
    if (!words.is_free(box.grown(0.4 * layout.em)) || is_crossed(box, contours, contour.level)) continue;
    words.put(Role::map, text, drawn, view.theme.text, box.least);
    return true;
  }
  return false;
}

// ---- The scale of colours -------------------------------------------------------------------------------------------

}  // namespace

std::string share_words(double share) {
  if (is_no_share(share)) return "0 %";
  constexpr long greatest = 999;
  const long percent = std::lround(100.0 * std::clamp(share, -1.0, 100.0));
  if (percent > greatest) return fmt::format("> +{} %", greatest);
  return fmt::format("{}{} %", percent > 0 ? "+" : "−", std::abs(percent));
}

bool is_no_share(double share) noexcept {
  return std::abs(share) < 0.005;
}

void add_map(const LandscapeView& view, const LandscapeLayout& layout, const Landscape& landscape, Marks& marks) {
  // Of the middles of the cells.
  std::array<double, map_columns> cosines{};
  for (int column = 0; column < map_columns; ++column) {
    cosines[static_cast<std::size_t>(column)] = std::cos(landscape_point_at({(column + 0.5) / map_columns, 0.0}).angle);
  }
  Raster raster{to_world(view.camera, layout.map.least), layout.map.extent(), map_columns, map_rows, {}};
  raster.cells.reserve(map_columns * map_rows);
  for (int row = 0; row < map_rows; ++row) {
    const double kappa = landscape_point_at({0.0, 1.0 - (row + 0.5) / map_rows}).kappa;
    const double ratio = landscape_ratio(landscape, kappa);
    for (const double cosine : cosines) {
      raster.cells.push_back(colour_of_share(view.theme, ghost_share(cosine, 1.0 + kappa, ratio, landscape.softness)));
    }
  }
  marks.push_back({Role::map, std::nullopt, std::move(raster)});
}

std::vector<DrawnContour> drawn_contours(const Landscape& landscape, const LandscapeLayout& layout) {
  constexpr double seen = 0.008;  // [em]
  // Along the wall no ghost force is left, however large it is a hair beside: all lines lie side by side there, and would
  // make the frame a thick bar.
  constexpr double beside_frame = 0.25;  // [em]
  const Vector<2> all(1.0);
  const ScreenBox room{layout.map.least - all, layout.map.most + Vector<2>(-beside_frame * layout.em, all.y)};
  std::vector<DrawnContour> drawn;
  for (const Contour& contour : contours_of(landscape)) {
    std::vector<Vector<2>> corners;
    for (const LandscapePoint& point : contour.points) corners.push_back(ring_at(layout, point));
    for (const std::vector<Vector<2>>& piece : pieces_inside(room, corners)) {
      drawn.push_back({contour.level, without_idle_corners(piece, seen * layout.em)});
    }
  }
  return drawn;
}

void add_contours(const LandscapeView& view, const LandscapeLayout& layout, const std::vector<DrawnContour>& contours,
                  Marks& marks) {
  const double dash = 0.4 * layout.em;
  const LinePattern dashes{dash, 0.7 * dash, dash, 0.7 * dash};
  for (const DrawnContour& contour : contours) {
    double along = 0.0;  // [m]
    for (std::size_t i = 1; i < contour.corners.size(); ++i) {
      const Line line{to_world(view.camera, contour.corners[i - 1]),
                      to_world(view.camera, contour.corners[i]),
                      contour_width(layout),
                      view.theme.text,
                      contour.level > 0.0 ? solid_line : dashes,
                      along};
      along += glm::distance(line.from, line.to);
      marks.push_back({Role::map, std::nullopt, line});
    }
  }
}

void add_contour_labels(const LandscapeView& view, const LandscapeLayout& layout,
                        const std::vector<DrawnContour>& contours, LandscapeWords& words) {
  // One a level, on the first of its pieces that has room.
  for (const double level : contour_levels) {
    std::ignore = std::ranges::any_of(contours, [&](const DrawnContour& contour) {
      return contour.level == level && add_contour_label(view, layout, contour, contours, words);
    });
  }
}

void add_colour_scale(const LandscapeView& view, const LandscapeLayout& layout, bool has_too_little,
                      LandscapeWords& words, Marks& marks) {
  const double lowest = has_too_little ? -depth_of_colour(-1.0) : 0.0;  // no share is less
  marks.push_back({Role::scale, std::nullopt,
                   Raster{to_world(view.camera, layout.scale.least), layout.scale.extent(), 1, scale_rows,
                          scale_of_shares(view.theme, lowest)}});
  marks.push_back({Role::scale, std::nullopt,
                   Box{to_world(view.camera, layout.scale.least), layout.scale.extent(), 0.0,
                       view.theme.background.with_alpha(0), view.theme.text, contour_width(layout)}});
  // The more important ones first: near 0 there is not room for all.
  const TextStyle drawn = words.style(1.0);
  for (const double share : {0.0, 2.0, 0.5, 1.0, -0.5, 0.1, -0.1}) {
    const double depth = std::copysign(depth_of_colour(share), share);
    if (depth < lowest) continue;
    const double y = layout.scale.least.y + layout.scale.extent().y * (1.0 - depth) / (1.0 - lowest);
    const Vector<2> place{layout.scale.most.x + 0.35 * layout.em, y};
    const Vector<2> extent = words.extent(share_words(share), drawn);
    const Vector<2> corner = place - Vector<2>(0.0, 0.5 * extent.y);
    if (!words.is_free({corner, corner + extent})) continue;
    words.put(Role::scale, share_words(share), drawn, view.theme.faint_text, place, {0.0, 0.5});
    marks.push_back({Role::scale, std::nullopt,
                     Line{to_world(view.camera, {layout.scale.most.x - 0.25 * layout.em, y}),
                          to_world(view.camera, {layout.scale.most.x, y}), contour_width(layout), view.theme.text}});
  }
}

}  // namespace ghostforce
