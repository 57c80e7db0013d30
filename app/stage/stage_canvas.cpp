#include "app/stage/stage_canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ghostforce {

void StageCanvas::line(Role role, const Vector<2>& from, const Vector<2>& to, double line_width, Colour colour,
                       const LinePattern& pattern) {
  LinePattern scaled = pattern;
  for (double& length : scaled) length *= unit;
  marks.push_back({role, {}, Line{to_world(camera, from), to_world(camera, to), line_width, colour, scaled}});
}

void StageCanvas::curve(Role role, const std::vector<Vector<2>>& corners, double line_width, Colour colour) {
  for (std::size_t i = 1; i < corners.size(); ++i) line(role, corners[i - 1], corners[i], line_width, colour);
}

void StageCanvas::coil(Role role, const Vector<2>& from, const Vector<2>& to, int turns, double line_width,
                       Colour colour) {
  const double length = glm::distance(from, to);
  if (length < points(1.0)) return;
  const Vector<2> along = (to - from) / length;
  const Vector<2> across{-along.y, along.x};
  // Pushed together, it becomes a line.
  const double lead = std::min(points(16.0), 0.15 * length);
  const double reach = std::min(points(8.0), 0.3 * length);
  const double pitch = (length - 2.0 * lead) / (2.0 * turns);
  std::vector<Vector<2>> corners{from, from + along * lead};
  for (int i = 0; i < 2 * turns; ++i) {
    corners.push_back(from + along * (lead + pitch * (i + 0.5)) + across * (i % 2 == 0 ? -reach : reach));
  }
  corners.push_back(to - along * lead);
  corners.push_back(to);
  curve(role, corners, line_width, colour);
  labels.keep_clear(from, to, reach + 0.5 * line_width);
}

void StageCanvas::ring(Role role, const Vector<2>& middle, double radius, double line_width, Colour colour) {
  constexpr int dashes = 10;
  constexpr int corners = 4;  // of a dash
  for (int dash = 0; dash < dashes; ++dash) {
    std::vector<Vector<2>> arc;
    for (int i = 0; i < corners; ++i) {
      const double turn = (dash + 0.6 * i / (corners - 1)) / dashes;
      const double angle = 2.0 * std::numbers::pi * turn;
      arc.push_back(middle + radius * Vector<2>(std::cos(angle), std::sin(angle)));
    }
    curve(role, arc, line_width, colour);
  }
}

void StageCanvas::disc(Role role, const Vector<2>& middle, double radius, Colour fill, Colour rim, double rim_width) {
  marks.push_back({role, {}, Marker{to_world(camera, middle), Shape::disc, radius, fill, rim, rim_width}});
}

void StageCanvas::box(Role role, const ScreenBox& box, double radius, Colour fill, Colour rim, double rim_width) {
  marks.push_back({role, {}, Box{to_world(camera, box.least), box.extent(), radius, fill, rim, rim_width}});
}

void StageCanvas::text(Role role, const Vector<2>& corner, std::string words, const TextStyle& style, Colour colour,
                       bool has_halo) {
  // A halo of its own strength would stand out before its letters do.
  const Colour halo = theme.background.with_alpha(has_halo && colour.alpha == 255 ? 255 : 0);
  marks.push_back({role, {}, Label{to_world(camera, corner), Vector<2>(0.0), std::move(words), style, colour, halo}});
}

void StageCanvas::text(Role role, const Vector<2>& corner, const std::vector<std::string>& lines,
                       const TextStyle& style, Colour colour, bool has_halo) {
  Vector<2> at = corner;
  for (const std::string& words : lines) {
    text(role, at, words, style, colour, has_halo);
    at.y += style.height;
  }
}

void StageCanvas::add_labels() {
  const auto found = labels.place(requests);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (requests[i].is_to_come || !found[i] || found[i]->strength <= 0.0) continue;
    const PlacedLabel& label = *found[i];
    const TextStyle& style = requests[i].style;
    const Colour colour = faded(colours_of_labels[i], label.strength);
    if (label.leader) {
      line(roles_of_labels[i], label.leader->from, label.leader->to, width(1.5),
           faded(theme.faint_text, label.strength));
    }
    Vector<2> at = label.box.least;
    for (const std::string& words : label.lines) {
      at.x = label.box.least.x + label.aligned * (label.box.extent().x - labels.extent_of({words}, style).x);
      text(roles_of_labels[i], at, words, style, colour);
      at.y += style.height;
    }
  }
}

}  // namespace ghostforce
