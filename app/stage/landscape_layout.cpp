#include "app/stage/landscape_layout.h"

#include <algorithm>
#include <cmath>

#include "app/stage/landscape_contours.h"

namespace ghostforce {
namespace {

// All of these in em, but for the shares of the picture.
constexpr double least_width = 39.7;   // of a picture in which every word finds its place,
constexpr double least_height = 17.0;  // between header and buttons, as the numbers below add up
constexpr double ems_in_height = 30.0;
constexpr double most_header_share = 0.4;  // of the height
constexpr double least_bottom_share = 0.6;
constexpr double margin = 1.2;
constexpr double below_header = 1.0 / 30.0;
constexpr double above_buttons = 0.7;
constexpr NumberRange column_width{13.0, 20.0};
constexpr double column_share = 0.3;     // of the width
constexpr double left_of_map = 3.35;     // the numbers of κ
constexpr double right_of_map = 6.65;    // the scale of colours and its numbers
constexpr double longest_map = 2.2;      // of its height
constexpr double one_line_title = 23.0;  // the width of a map that has its title in one line
constexpr double above_dial = 12.3;      // title, number and words
constexpr double below_dial = 4.9;       // its ends' names, and what one can drag
constexpr double widest_dial = 16.0;

}  // namespace

LandscapeLayout landscape_layout(const Vector<2>& size, double unit, const LandscapeRoom& room) noexcept {
  LandscapeLayout layout;
  // False for a NaN.
  for (const glm::length_t axis : {0, 1}) layout.size[axis] = size[axis] >= 1.0 ? std::min(size[axis], 1e6) : 1.0;
  const double width = layout.size.x;
  const double height = layout.size.y;
  // The first of two for a NaN. Some map is left in any picture.
  const double header_end = std::min(most_header_share * height, std::max(0.0, room.header.most.y));
  const double rows = std::min(height, std::max(least_bottom_share * height, room.bottom));
  const double greatest = std::min(width / least_width, (rows - header_end) / least_height);
  const double em = std::clamp(unit > 0.0 ? unit * height / ems_in_height : greatest, 0.01 * greatest, greatest);
  layout.em = em;
  layout.ring_radius = 0.6 * em;
  layout.knob_radius = 0.7 * em;
  const double bottom = rows - above_buttons * em;
  const double top = header_end + below_header * em;

  const double column_right = (margin + column_width.nearest_to(column_share * width / em)) * em;
  const bool is_under_header = column_right > room.header.least.x;
  layout.column = {{margin * em, is_under_header ? top : 0.9 * em}, {column_right, bottom}};

  layout.axis_title_top = top;
  layout.map.least = {column_right + left_of_map * em, top + (line_height + beside_map) * em};
  layout.map.most.x = width - right_of_map * em;
  const double lines_below = layout.map.extent().x < one_line_title * em ? 3.0 : 2.0;  // numbers and title
  layout.map.most.y = bottom - (lines_below * line_height + beside_map + 0.1) * em;
  layout.map.most.x = std::min(layout.map.most.x, layout.map.least.x + longest_map * layout.map.extent().y);

  layout.scale = {{layout.map.most.x + 0.95 * em, layout.map.least.y},
                  {layout.map.most.x + 1.75 * em, layout.map.most.y}};

  const double slack = layout.column.extent().y - (above_dial + below_dial) * em;
  const double dial_y = layout.column.least.y + above_dial * em + 0.35 * slack;
  layout.dial = {{layout.column.least.x + 0.8 * em, dial_y},
                 {std::min(column_right, layout.column.least.x + widest_dial * em) - 0.8 * em, dial_y}};
  return layout;
}

Vector<2> ring_at(const LandscapeLayout& layout, const LandscapePoint& point) noexcept {
  const LandscapePoint shown{point.angle, shown_kappas.nearest_to(point.kappa)};
  const Vector<2> place = glm::clamp(map_place(shown), Vector<2>(0.0), Vector<2>(1.0));
  return {layout.map.least.x + place.x * layout.map.extent().x, layout.map.most.y - place.y * layout.map.extent().y};
}

LandscapePoint landscape_point_under(const LandscapeLayout& layout, const Vector<2>& screen) noexcept {
  const Vector<2> at = glm::clamp(screen, layout.map.least, layout.map.most);
  const Vector<2> extent = layout.map.extent();
  return landscape_point_at({(at.x - layout.map.least.x) / extent.x, (layout.map.most.y - at.y) / extent.y});
}

bool is_on_map(const LandscapePoint& point) noexcept {
  constexpr double rounding = 1e-9;  // of the ring at an edge of the map, on its way into the settings and back
  return std::abs(shown_kappas.nearest_to(point.kappa) - point.kappa) <= rounding * point.kappa;
}

Vector<2> knob_at(const LandscapeLayout& layout, double dial) noexcept {
  return layout.dial.least + (layout.dial.most - layout.dial.least) * std::clamp(dial, 0.0, 1.0);
}

double dial_under(const LandscapeLayout& layout, const Vector<2>& screen) noexcept {
  return std::clamp((screen.x - layout.dial.least.x) / layout.dial.extent().x, 0.0, 1.0);
}

LandscapeHandle landscape_handle_under(const LandscapeLayout& layout, const Vector<2>& screen) noexcept {
  if (contains(layout.dial.grown(1.5 * layout.knob_radius), screen)) return LandscapeHandle::dial;
  if (contains(layout.map.grown(layout.ring_radius), screen)) return LandscapeHandle::ring;
  return LandscapeHandle::none;
}

}  // namespace ghostforce
