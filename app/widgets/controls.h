// Small pieces that several panels are made of: the look of it all, colours for ImGui, glyphs of strategies, rows of name
// and slider, explanations on hover.
#pragma once

#include <string>
#include <string_view>

#include <imgui.h>

#include "app/widgets/panel_context.h"
#include "app/widgets/tooltips.h"

namespace ghostforce {

// Dresses Dear ImGui in a theme at a UI scale.
void apply_style(const Theme& theme, float scale);

ImU32 packed(Colour colour);
ImVec4 unpacked(Colour colour);

// How wide a button is that says this.
float button_width(const char* words);

// Words in another font or colour, or with their symbols and broken where they reach `end` of the window; 0: its right
// edge.
void text_in(ImFont* font, std::string_view words);
void text_in(Colour colour, std::string_view words);
void wrapped_text(std::string_view words, float end = 0.0F);

// How high letters may be so that the words have room; not above `height` [points].
float letters_for(const std::string& words, ImFont* font, float room, float height);

// ● ◆ ▲ as the scene draws them.
void draw_glyph(ImDrawList& draw_list, ImVec2 center, float radius, Shape shape, Colour fill);

// A two-column grid of names and controls; call begin, rows, end. A row leaves the control at full width next.
bool begin_rows(const char* id, const PanelContext& context);
void row(const char* name, Term term);
void row(const char* name, std::string_view sentence);
void end_rows();

// ImGui::SameLine() for an item of that width, unless it would be cut off there [points].
void same_line_if_room(float width);

// A field for a line of text, as wide as the next item is set to be; true when Enter was pressed in it.
bool text_field(const char* id, const char* hint, std::string& text,
                ImGuiInputTextFlags flags = ImGuiInputTextFlags_AutoSelectAll);

// The same, but it keeps the keyboard when Enter is pressed, and the arrows up and down are for the list beside it.
bool search_field(const char* id, const char* hint, std::string& text);

struct SliderLimits {
  double least;
  double greatest;
};
// Clamps what is typed into it as well, unless the flags are others. With the keyboard's focus, an arrow changes it by
// a hundredth of its length; Shift or Alt: by a thousandth, Ctrl: by a tenth; Home and End go to its ends.
bool slider(const char* id, double& value, const SliderLimits& limits, const char* format,
            ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp);

// A logarithmic slider with the value and its unit in it. Ctrl+click types any number that the scene's `key` may have.
bool stiffness_slider(const char* id, std::string_view key, double& newton_per_metre, const SliderLimits& limits);

// Degrees on screen, radians inside. Arrows turn it by 1°, Shift or Alt 0.1°, Ctrl 10°, and on beyond 180°: angles have
// no end.
bool angle_slider(const char* id, double& radians);

// How wide a field of a dialog may be that would like to be `points` wide: the dialog has to stay inside the window.
float dialog_field_width(float points, const PanelContext& context);

// Of the item just drawn: the pointer holds it, or has let go of it within a frame in which it moved. Who is quick
// presses, drags and lets go between two frames.
bool is_dragged();

// Closes the popup that is being drawn when Esc is pressed.
void close_popup_on_escape();

// A strategy in the first cell of its row: shape and letter, and its sentence for who hovers over them.
void draw_strategy_name(const PanelContext& context, const Strategy& entry, ImFont* font);

// The next cell, in digits that are all equally wide.
void number_cell(const PanelContext& context, const std::string& text);

}  // namespace ghostforce
