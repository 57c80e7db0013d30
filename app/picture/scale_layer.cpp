// How long a millimetre and a newton are in the picture.
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "app/picture/label_placer.h"
#include "app/picture/layers.h"
#include "app/picture/screen_box.h"
#include "core/conventions.h"

namespace ghostforce {
namespace {

constexpr double scale_margin = 14.0;  // to the edge of the picture [points]
constexpr double scale_row = 22.0;
constexpr double scale_gap = 8.0;      // from a bar to its words
constexpr double scale_padding = 5.0;  // of the backdrop
constexpr double scale_tick = 4.0;
constexpr double longest_bar = 110.0;
constexpr double share_for_bar = 0.24;  // of the picture's width, at most

struct ScaleBar {
  double length;  // [points]
  std::string words;
};

// The greatest of 1, 2, 5, 10 … that is at most so long; the steps are decimal digits of the unit.
ScaleBar bar_of(double points_per_unit, double longest, std::string_view unit) {
  double number = std::pow(10.0, std::floor(std::log10(longest / points_per_unit)));
  for (const double step : {5.0, 2.0}) {
    if (step * number * points_per_unit <= longest) {
      number *= step;
      break;
    }
  }
  return {number * points_per_unit, fmt::format("{:.3g} {}", number, unit)};
}

}  // namespace

void add_scales(const View& view, LabelPlacer& labels, CornerMemory& memory, Marks& marks) {
  const double longest = std::min(view.points(longest_bar), share_for_bar * view.camera.size.x);
  const std::array bars{bar_of(view.points_per_newton, longest, "N"),
                        bar_of(view.camera.points_per_metre / mm_per_m, longest, "mm")};
  const double padding = view.points(scale_padding);
  const double gap = view.points(scale_gap);
  Vector<2> extent{0.0, 2.0 * view.points(scale_row) + padding};
  for (const ScaleBar& bar : bars) {
    extent.x = std::max(extent.x, bar.length + gap + view.measure(bar.words, view.drawn(small_text)).x);
  }
  extent.x += 2.0 * padding;
  const double margin = std::min(view.points(scale_margin), 0.02 * view.camera.size.x);
  const Vector<2>& size = view.camera.size;
  std::vector<ScreenBox> places;
  const ScreenBox corner = box_in_corner(Corner::lower_left, extent, size, margin);
  const Vector<2> above_caption(0.0, -2.0 * view.points(scale_row));
  places.push_back(corner);
  places.push_back({corner.least + above_caption, corner.most + above_caption});
  for (const double share : {0.22, 0.44}) {
    const Vector<2> along(share * size.x, 0.0);
    places.push_back({corner.least + along, corner.most + along});
  }
  for (const Corner upper : {Corner::upper_left, Corner::upper_right}) {
    places.push_back(box_in_corner(upper, extent, size, margin));
  }
  const auto found = place_in_corner(places, places.size(), labels, memory);
  if (!found || found->strength <= 0.0) return;
  const ScreenBox& box = places[found->place];
  const ScreenPen pen{view, marks, Role::scale, found->strength};
  pen.backdrop(box);
  const Colour colour = view.theme.text;
  const Vector<2> tick(0.0, view.points(scale_tick));
  Vector<2> from = box.least + Vector<2>(padding, 0.5 * padding + 0.5 * view.points(scale_row));
  for (const ScaleBar& bar : bars) {
    const Vector<2> to = from + Vector<2>(bar.length, 0.0);
    pen.line(from, to, 2.0, colour);
    for (const Vector<2>& end : {from, to}) pen.line(end - tick, end + tick, 2.0, colour);
    pen.text(to + Vector<2>(gap, -0.55 * view.measure(bar.words, view.drawn(small_text)).y), bar.words, colour);
    from.y += view.points(scale_row);
  }
}

}  // namespace ghostforce
