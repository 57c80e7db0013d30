// Small pieces that several panels are made of: colours for ImGui, glyphs of strategies, rows of name and slider,
// explanations on hover.
#pragma once

#include <string_view>

#include <imgui.h>

#include "app/panels/panel.h"

namespace ghostforce {

ImU32 packed(Colour colour);
ImVec4 unpacked(Colour colour);

// ● ◆ ▲ as the scene draws them.
void draw_glyph(ImDrawList& draw_list, ImVec2 center, float radius, Shape shape, Colour fill);

// One sentence on the item just drawn, after a moment of hovering.
void explain(std::string_view sentence);

// A two-column grid of names and controls; call begin, rows, end. A row leaves the control at full width next.
bool begin_rows(const char* id, const PanelContext& context);
void row(const char* name, std::string_view sentence);
void end_rows();

// A logarithmic slider with the value and its unit in it; Ctrl+click types a number, which is held within the limits.
struct SliderLimits {
  double least;
  double greatest;
};
bool stiffness_slider(const char* id, double& newton_per_metre, const SliderLimits& limits);

// Degrees on screen, radians inside. Drags without an end: angles have none.
bool angle_slider(const char* id, double& radians);

}  // namespace ghostforce
