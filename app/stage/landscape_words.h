// The landscape's words: each in its place, in letters of the layout, never wider than its room; and what of the
// picture they have taken. Screen points, y down. One picture at a time.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/marks.h"
#include "app/picture/screen_box.h"
#include "app/stage/landscape_layout.h"

namespace ghostforce {

// The same words, broken into lines in several ways, from the widest to the narrowest.
using LineBreaks = std::vector<std::vector<std::string>>;
// As a language's table has them: lines separated by "\n", ways by "|".
LineBreaks line_breaks_of(std::string_view words);

// Where a line of text lies about its place: 0 begins there, 0.5 has its middle there, 1 ends there.
struct Alignment {
  double across = 0.0;
  double down = 0.0;
};

class LandscapeWords {
 public:
  LandscapeWords(const LandscapeView& view, const LandscapeLayout& layout, Marks& marks)
      : view_(view), layout_(layout), marks_(marks) {}

  Vector<2> extent(std::string_view text, const TextStyle& drawn) const { return view_.measure(text, drawn); }
  // Letters of that many em.
  TextStyle style(double ems, bool is_bold = false) const { return {ems * line_height * layout_.em, is_bold}; }
  // Smaller where the text is wider than its room.
  TextStyle fitted(std::string_view text, TextStyle drawn, double room) const {
    if (const double width = extent(text, drawn).x; width > room) drawn.height *= room / width;
    return drawn;
  }

  // Returns the box that it takes.
  ScreenBox put(Role role, std::string text, const TextStyle& drawn, Colour colour, const Vector<2>& place,
                const Alignment& alignment = {}, std::optional<StrategyId> strategy = {}) {
    const Vector<2> size = extent(text, drawn);
    const Vector<2> corner = place - Vector<2>(alignment.across, alignment.down) * size;
    marks_.push_back({role, strategy,
                      Label{to_world(view_.camera, corner), Vector<2>(0.0), std::move(text), drawn, colour,
                            view_.theme.background}});
    taken_.push_back({corner, corner + size});
    return taken_.back();
  }

  // In lines of one em below each other, broken in the first way that fits the room; the last, smaller, where none
  // does. Returns their lower end.
  double put_lines(Role role, const LineBreaks& ways, Colour colour, const Vector<2>& place, double room,
                   double across = 0.0);
  double height_of_lines(const LineBreaks& ways, double room) const;

  void take(const ScreenBox& box) { taken_.push_back(box); }
  bool is_free(const ScreenBox& box) const {
    return std::ranges::none_of(taken_, [&](const ScreenBox& other) { return overlap(box, other) > 0.0; });
  }

 private:
  const std::vector<std::string>& way_that_fits(const LineBreaks& ways, double room) const;

  const LandscapeView& view_;
  const LandscapeLayout& layout_;
  Marks& marks_;
  std::vector<ScreenBox> taken_;
};

}  // namespace ghostforce
