#include "app/paint/label_painter.h"

#include <cmath>
#include <cstddef>

namespace ghostforce {
namespace {

ImU32 packed(Colour colour) {
  return IM_COL32(colour.red, colour.green, colour.blue, colour.alpha);
}

ImFont& font_of(const LabelFonts& fonts, const TextStyle& style) {
  return style.is_bold ? *fonts.bold : *fonts.regular;
}

struct Pen {
  ImDrawList& draw_list;
  ImFont& font;
  float height;  // [points]
  bool on_whole_pixels;

  void write(ImVec2 corner, ImU32 colour, std::string_view text) const {
    if (!on_whole_pixels) {
      draw(corner, colour, text);
      return;
    }
    for (float along = 0.0F; !text.empty();) {
      const std::string_view letter = text.substr(0, length_of_first(text));
      draw({std::trunc(corner.x) + std::round(along), corner.y}, colour, letter);
      along += font.CalcTextSizeA(height, 1e9F, 0.0F, letter.data(), letter.data() + letter.size()).x;
      text.remove_prefix(letter.size());
    }
  }

 private:
  void draw(ImVec2 corner, ImU32 colour, std::string_view text) const {
    draw_list.AddText(&font, height, corner, colour, text.data(), text.data() + text.size());
  }
  static std::size_t length_of_first(std::string_view text) {
    std::size_t length = 1;
    while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) ++length;
    return length;
  }
};

}  // namespace

Vector<2> measure_text(const LabelFonts& fonts, std::string_view text, const TextStyle& style) {
  const ImVec2 size =
      font_of(fonts, style)
          .CalcTextSizeA(static_cast<float>(style.height), 1e9F, 0.0F, text.data(), text.data() + text.size());
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
    const auto height = static_cast<float>(label->style.height * height_scale);
    // Between pixels, the empty texels round a large letter would darken its edges, which shows where it is a halo.
    const bool is_large = label->style.height > large_text.height;
    const Pen pen{draw_list, font_of(fonts, label->style), height, is_large};
    const auto write = [&](float dx, float dy, ImU32 colour) {
      pen.write({corner.x + dx, corner.y + dy}, colour, label->text);
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
