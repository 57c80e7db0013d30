// What the marks of a picture cover on the screen, told from their geometry and nothing else, as a person with a ruler
// would: so that a test of what stands where need not believe the code that placed it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/panes.h"
#include "app/picture/screen_box.h"
#include "app/picture/view.h"

namespace ghostforce {

// A closed polygon or a line, and all that is no farther from it than `radius`.
struct Extent {
  Role role{};
  std::vector<Vector<2>> corners{};
  double radius = 0.0;
  std::size_t mark = 0;  // which of the picture's
};

struct LabelExtent {
  Role role{};
  std::string words{};
  TextStyle style{};
  ScreenBox box{};
  double alpha = 1.0;
  std::size_t mark = 0;
};

inline double distance_to(const Vector<2>& point, const Vector<2>& from, const Vector<2>& to) {
  const Vector<2> way = to - from;
  const double length = glm::dot(way, way);
  const double share = length > 0.0 ? std::clamp(glm::dot(point - from, way) / length, 0.0, 1.0) : 0.0;
  return glm::distance(point, from + share * way);
}

inline double distance_between(const ScreenBox& box, const Vector<2>& from, const Vector<2>& to) {
  ScreenPiece piece{from, to, 0.0};
  if (clip(box, piece)) return 0.0;
  double least = 1e300;
  for (const Vector<2>& corner :
       {box.least, box.most, Vector<2>(box.least.x, box.most.y), Vector<2>(box.most.x, box.least.y)}) {
    least = std::min(least, distance_to(corner, from, to));
  }
  for (const Vector<2>& end : {from, to}) {
    least = std::min(least, glm::distance(end, glm::clamp(end, box.least, box.most)));
  }
  return least;
}

inline bool lies_inside(const Vector<2>& point, const std::vector<Vector<2>>& corners) {
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Vector<2>& a = corners[i];
    const Vector<2>& b = corners[j];
    if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x) {
      inside = !inside;
    }
  }
  return inside;
}

// How deep the mark reaches into the box [points]; 0 or less: not at all.
inline double reach_into(const ScreenBox& box, const Extent& extent) {
  const std::vector<Vector<2>>& corners = extent.corners;
  if (corners.size() > 2 && lies_inside(0.5 * (box.least + box.most), corners)) return 1e3;
  double nearest = 1e300;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    nearest = std::min(nearest, distance_between(box, corners[i], corners[(i + 1) % corners.size()]));
  }
  return extent.radius - nearest;
}

inline double distance_between_lines(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d) {
  const auto side = [](const Vector<2>& p, const Vector<2>& q, const Vector<2>& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  if (side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0) return 0.0;
  return std::min({distance_to(a, c, d), distance_to(b, c, d), distance_to(c, a, b), distance_to(d, a, b)});
}

// The same of a thin line.
inline double reach_into(const Vector<2>& from, const Vector<2>& to, const Extent& extent) {
  const std::vector<Vector<2>>& corners = extent.corners;
  if (corners.size() > 2 && (lies_inside(from, corners) || lies_inside(to, corners))) return 1e3;
  double nearest = 1e300;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    nearest = std::min(nearest, distance_between_lines(from, to, corners[i], corners[(i + 1) % corners.size()]));
  }
  return extent.radius - nearest;
}

class PictureExtents {
 public:
  // A line that leads from words to what they name.
  struct Leader {
    Vector<2> from;
    Vector<2> to;
    std::size_t label = 0;  // which of labels
  };

  // `text_scale`: from a label's own height to the one that it is drawn with.
  PictureExtents(const Pane& pane, const MeasureText& measure, double text_scale = 1.0) : camera_(pane.camera) {
    for (std::size_t i = 0; i < pane.marks.size(); ++i) {
      const Mark& mark = pane.marks[i];
      is_finite &= std::visit([](const auto& form) { return all_finite(form); }, mark.form);
      if (const auto* const label = std::get_if<Label>(&mark.form)) {
        const Vector<2> corner = to_screen(camera_, label->anchor) + label->offset;
        const TextStyle drawn{label->style.height * text_scale, label->style.is_bold};
        const ScreenBox box{corner, corner + measure(label->text, drawn)};
        labels.push_back({mark.role, label->text, label->style, box, label->colour.alpha / 255.0, i});
        continue;
      }
      // A line whose next mark is words of the same kind leads to them.
      const auto* const line = std::get_if<Line>(&mark.form);
      if (line != nullptr && mark.role != Role::button && i + 1 < pane.marks.size() &&
          pane.marks[i + 1].role == mark.role && std::holds_alternative<Label>(pane.marks[i + 1].form)) {
        leaders.push_back({to_screen(camera_, line->from), to_screen(camera_, line->to), labels.size()});
        continue;
      }
      if (auto extent = extent_of(mark)) {
        extent->mark = i;
        marks.push_back(std::move(*extent));
      }
    }
  }

  std::vector<LabelExtent> labels{};
  std::vector<Extent> marks{};  // what can be covered: no fillings, no hatching of the wall
  std::vector<Leader> leaders{};
  bool is_finite = true;

 private:
  static bool all_finite(double number) { return std::isfinite(number); }
  static bool all_finite(const Vector<2>& point) { return std::isfinite(point.x) && std::isfinite(point.y); }
  static bool all_finite(const HalfPlane& form) { return all_finite(form.point) && all_finite(form.normal); }
  static bool all_finite(const Line& form) {
    return all_finite(form.from) && all_finite(form.to) && all_finite(form.width) && all_finite(form.pattern_start);
  }
  static bool all_finite(const Marker& form) { return all_finite(form.center) && all_finite(form.radius); }
  static bool all_finite(const Arrow& form) {
    return all_finite(form.tail) && all_finite(form.tip) && all_finite(form.width);
  }
  static bool all_finite(const Box& form) { return all_finite(form.corner) && all_finite(form.size); }
  static bool all_finite(const Area& form) {
    return std::ranges::all_of(form.corners, [](const Vector<2>& corner) { return all_finite(corner); });
  }
  static bool all_finite(const Raster& form) { return all_finite(form.corner) && all_finite(form.size); }
  static bool all_finite(const Label& form) {
    return all_finite(form.anchor) && all_finite(form.offset) && all_finite(form.style.height);
  }

  Vector<2> at(const Vector<2>& world) const { return to_screen(camera_, world); }

  std::optional<Extent> extent_of(const Mark& mark) const {
    if (mark.role == Role::hatching) return std::nullopt;
    if (const auto* const line = std::get_if<Line>(&mark.form)) {
      if (line->colour.alpha == 0) return std::nullopt;
      return Extent{mark.role, {at(line->from), at(line->to)}, 0.5 * line->width};
    }
    if (const auto* const marker = std::get_if<Marker>(&mark.form)) return extent_of(mark.role, *marker);
    if (const auto* const arrow = std::get_if<Arrow>(&mark.form)) return extent_of(mark.role, *arrow);
    if (const auto* const box = std::get_if<Box>(&mark.form)) {
      const Vector<2> corner = at(box->corner) + box->offset;
      const Vector<2>& size = box->size;
      return Extent{mark.role,
                    {corner, corner + Vector<2>(size.x, 0.0), corner + size, corner + Vector<2>(0.0, size.y)},
                    0.5 * box->rim_width};
    }
    return std::nullopt;
  }

  // As the painters draw them (shaders/mark.frag).
  Extent extent_of(Role role, const Marker& marker) const {
    const Vector<2> middle = at(marker.center) + marker.offset;
    const double r = marker.radius;
    const double half_rim = 0.5 * marker.rim_width;
    switch (marker.shape) {
      case Shape::disc:
        return {role, {middle}, r + half_rim};
      case Shape::diamond:
        return {role,
                {middle + Vector<2>(0.0, -1.3 * r), middle + Vector<2>(1.3 * r, 0.0), middle + Vector<2>(0.0, 1.3 * r),
                 middle + Vector<2>(-1.3 * r, 0.0)},
                half_rim};
      case Shape::triangle:
        return {role,
                {middle + Vector<2>(0.0, -1.564 * r), middle + Vector<2>(1.25 * r, 0.602 * r),
                 middle + Vector<2>(-1.25 * r, 0.602 * r)},
                half_rim};
    }
    return {};
  }

  Extent extent_of(Role role, const Arrow& arrow) const {
    const Vector<2> tail = at(arrow.tail) + arrow.offset;
    const Vector<2> tip = at(arrow.tip) + arrow.offset;
    const double length = glm::distance(tail, tip);
    const double half_rim = 0.5 * arrow.rim_width;
    if (!(length > 0.0)) return {role, {tail}, half_rim};
    const Vector<2> along = (tip - tail) / length;
    const Vector<2> across{-along.y, along.x};
    const double half = 0.5 * arrow.width;
    const auto place = [&](double x, double y) { return tail + along * x + across * y; };
    if (!arrow.has_head) {
      return {role, {place(0.0, -half), place(length, -half), place(length, half), place(0.0, half)}, half_rim};
    }
    const double half_head = 2.3 * half;
    const double neck = length - std::min(1.9 * half_head, 0.8 * length);
    return {role,
            {place(0.0, -half), place(neck, -half), place(neck, -half_head), tip, place(neck, half_head),
             place(neck, half), place(0.0, half)},
            half_rim};
  }

  Camera camera_;
};

}  // namespace ghostforce
