// Paints the labels among marks with the screen's font, above everything that the GL painter drew. Needs an ImGui
// frame.
#pragma once

#include <imgui.h>

#include "app/view/camera.h"
#include "app/view/marks.h"
#include "app/view/view.h"

namespace ghostforce {

// `origin` is the upper left corner of the camera's rectangle on the screen; `height_scale` turns a label's nominal
// text height into points.
void paint_labels(const Marks& marks, const Camera& camera, ImVec2 origin, double height_scale, ImDrawList& draw_list);

// The font's own measure; the same letters that paint_labels() draws.
Vector<2> measure_text(std::string_view text, double height);

}  // namespace ghostforce
