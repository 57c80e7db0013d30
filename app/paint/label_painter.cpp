#include "app/paint/label_painter.h"

#include <algorithm>
#include <cmath>

namespace ghostforce {
namespace {

ImU32 packed(Colour colour) {
  return IM_COL32(colour.red, colour.green, colour.blue, colour.alpha);
}

ImFont& font_of(const LabelFonts& fonts, const TextStyle& style) {
  return style.is_bold ? *fonts.bold : *fonts.regular;
}

// Whole pixels, as ImGui draws letters: others would be stretched from the nearest, and blurred.
float pixels_high(double height) {
  return static_cast<float>(std::max(1.0, std::round(height)));
}

}  // namespace

Vector<2> measure_text(const LabelFonts& fonts, std::string_view text, const TextStyle& style) {
  const ImVec2 size = font_of(fonts, style)
                          .CalcTextSizeA(pixels_high(style.height), 1e9F, 0.0F, text.data(), text.data() + text.size());
  return {static_cast<double>(size.x), static_cast<double>(size.y)};
}

MeasureText measure_with(const LabelFonts& fonts) {
  return [fonts](std::string_view text, const TextStyle& style) { return measure_text(fonts, text, style); };
}

void paint_labels(const Marks& marks, const Camera& camera, const LabelFonts& fonts, ImVec2 origin, double height_scale,
                  ImDrawList& draw_list) {
  draw_list.PushClipRect(origin,
                         {origin.x + static_cast<float>(camera.size.x), origin.y + static_cast<float>(camera.size.y)});
  for (const Mark& mark : marks) {
    const auto* label = std::get_if<Label>(&mark.form);
    if (label == nullptr) continue;
    const Vector<2> at = to_screen(camera, label->anchor) + label->offset;
    const ImVec2 corner{origin.x + static_cast<float>(at.x), origin.y + static_cast<float>(at.y)};
    const float height = pixels_high(label->style.height * height_scale);
    const char* const text = label->text.data();
    const auto write = [&](float dx, float dy, ImU32 colour) {
      draw_list.AddText(&font_of(fonts, label->style), height, {corner.x + dx, corner.y + dy}, colour, text,
                        text + label->text.size());
    };
    if (label->halo.alpha > 0) {
      const float reach = 0.1F * height;
      const ImU32 halo = packed(label->halo.with_alpha(200));
      for (const float dx : {-reach, 0.0F, reach}) {
        for (const float dy : {-reach, 0.0F, reach}) {
          if (dx != 0.0F || dy != 0.0F) write(dx, dy, halo);
        }
      }
    }
    write(0.0F, 0.0F, packed(label->colour));
  }
  draw_list.PopClipRect();
}

}  // namespace ghostforce
