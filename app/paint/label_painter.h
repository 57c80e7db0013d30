// Paints the labels among marks with the screen's font, above everything that the GL painter drew. Needs an ImGui
// frame.
#pragma once

#include <imgui.h>

#include "app/picture/camera.h"
#include "app/picture/marks.h"
#include "app/picture/view.h"

namespace ghostforce {

// They belong to ImGui.
struct LabelFonts {
  ImFont* regular;
  ImFont* bold;
};

// `origin` is the upper left corner of the camera's rectangle on the screen; `height_scale` turns a label's nominal
// text height into points.
void paint_labels(const Marks& marks, const Camera& camera, const LabelFonts& fonts, ImVec2 origin, double height_scale,
                  ImDrawList& draw_list);

// The fonts' own measure; the same letters that paint_labels() draws.
Vector<2> measure_text(const LabelFonts& fonts, std::string_view text, const TextStyle& style);
// The same for who knows no fonts.
MeasureText measure_with(const LabelFonts& fonts);

}  // namespace ghostforce
