// Whether the words of a picture can be read: each against what lies behind it, told from the marks alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/picture/contrast.h"
#include "tests/app/picture/picture_extents.h"

namespace ghostforce {

// `over` on `under`, opaque.
inline Colour laid_on(Colour under, Colour over) {
  return mix(under, over.with_alpha(255), over.alpha / 255.0).with_alpha(255);
}

// What is painted at a place of the screen before any words are: fillings, not lines, which labels keep clear of or
// have a halo against.
inline Colour ground_at(const Pane& pane, const Theme& theme, const Vector<2>& place) {
  Colour ground = theme.background;
  const auto at = [&](const Vector<2>& world) { return to_screen(pane.camera, world); };
  for (const Mark& mark : pane.marks) {
    if (const auto* const half = std::get_if<HalfPlane>(&mark.form)) {
      if (glm::dot(to_world(pane.camera, place) - half->point, half->normal) < 0.0)
        ground = laid_on(ground, half->fill);
    } else if (const auto* const box = std::get_if<Box>(&mark.form)) {
      const Vector<2> corner = at(box->corner) + box->offset;
      if (contains(ScreenBox{corner, corner + box->size}, place)) ground = laid_on(ground, box->fill);
    } else if (const auto* const area = std::get_if<Area>(&mark.form)) {
      std::vector<Vector<2>> corners;
      for (const Vector<2>& corner : area->corners) corners.push_back(at(corner));
      if (lies_inside(place, corners)) ground = laid_on(ground, area->fill);
    } else if (const auto* const raster = std::get_if<Raster>(&mark.form)) {
      const Vector<2> corner = at(raster->corner);
      if (!contains(ScreenBox{corner, corner + raster->size}, place)) continue;
      const Vector<2> cell = (place - corner) / raster->size * Vector<2>(raster->columns, raster->rows);
      const int column = std::clamp(static_cast<int>(cell.x), 0, raster->columns - 1);
      const int row = std::clamp(static_cast<int>(cell.y), 0, raster->rows - 1);
      ground = raster->cells[static_cast<std::size_t>(row * raster->columns + column)];
    }
  }
  return ground;
}

// Empty: all can be read. `text_scale`: as of PictureExtents.
inline std::vector<std::string> unreadable_words(const Pane& pane, const Theme& theme, const MeasureText& measure,
                                                 double text_scale = 1.0) {
  std::vector<std::string> faults;
  for (const LabelExtent& words : PictureExtents(pane, measure, text_scale).labels) {
    const Label& label = std::get<Label>(pane.marks[words.mark].form);
    if (label.colour.alpha == 0) continue;
    double worst = 21.0;
    for (const double x : {0.02, 0.25, 0.5, 0.75, 0.98}) {
      for (const double y : {0.2, 0.5, 0.8}) {
        const Vector<2> place = words.box.least + Vector<2>(x, y) * words.box.extent();
        const Colour under = ground_at(pane, theme, place);
        const Colour ground = label.halo.alpha > 0 ? laid_on(under, label.halo) : under;
        worst = std::min(worst, contrast(laid_on(ground, label.colour), ground));
      }
    }
    if (worst < least_word_contrast) faults.push_back(fmt::format("'{}' has a contrast of {:.2f}", words.words, worst));
  }
  return faults;
}

}  // namespace ghostforce
