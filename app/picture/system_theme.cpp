#include "app/picture/system_theme.h"

#include "app/picture/contrast.h"

namespace ghostforce {

Theme system_theme(const SystemColours& colours) noexcept {
  const Colour canvas = colours.canvas;
  const Colour text = colours.canvas_text;
  const auto readable = [&](Colour wanted) { return contrast(wanted, canvas) >= least_word_contrast ? wanted : text; };
  // Of lines and fillings, which carry no words.
  const auto tint = [&](double share) { return mix(canvas, text, share); };
  const Colour highlight = readable(colours.highlight);
  const Colour link = readable(colours.link_text);
  const PerStrategy<Colour> strategy{text, link, highlight};
  return {.name = "system",
          .dark = contrast(canvas, rgb(0xFFFFFF)) > contrast(canvas, rgb(0x000000)),
          .thickness = 1.0,
          .strategy = strategy,
          .strategy_text = strategy,
          .goal = highlight,
          .goal_rim = text,
          .background = canvas,
          .wall = canvas,
          .hatch = tint(0.5),
          .wall_edge = text,
          .grid = tint(0.1),
          .text = text,
          .faint_text = text,
          .panel = canvas,
          .panel_field = canvas,
          .panel_border = text,
          .accent = highlight,
          .excess = link,
          .shortfall = readable(colours.gray_text),
          .problem = text};
}

}  // namespace ghostforce
