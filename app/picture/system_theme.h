// A theme made of the few colours that a person has told the system to use for everything (forced colours, high
// contrast). Pure; any thread.
#pragma once

#include "app/picture/theme.h"

namespace ghostforce {

// By the names of CSS. The text can be read on the canvas, or nothing can be.
struct SystemColours {
  Colour canvas;
  Colour canvas_text;
  Colour link_text;
  Colour highlight;
  Colour gray_text;

  friend bool operator==(const SystemColours&, const SystemColours&) = default;
};

// Words have a colour of the system's that can be read on the canvas. Strategies are told apart by shape, pattern and
// letter, as ever, and by colour as far as the system has different ones.
Theme system_theme(const SystemColours& colours) noexcept;

}  // namespace ghostforce
