// ScreenPen: draws what has its place on the screen, not in the world, in points of the picture (y down). One thread.
#pragma once

#include <string>
#include <utility>

#include "app/picture/marks.h"
#include "app/picture/screen_box.h"
#include "app/picture/view.h"

namespace ghostforce {

struct ScreenPen {
  const View& view;
  Marks& marks;
  Role role;
  double strength = 1.0;  // 0: not to be seen

  void line(const Vector<2>& from, const Vector<2>& to, double width, Colour colour,
            LinePattern pattern = solid_line) const {
    marks.push_back({role, std::nullopt,
                     Line{to_world(view.camera, from), to_world(view.camera, to), view.points(width),
                          faded(colour, strength), pattern}});
  }
  void text(const Vector<2>& upper_left, std::string words, Colour colour, const TextStyle& style = small_text) const {
    // A halo of its own strength would stand out before its letters do.
    const Colour halo = view.theme.background.with_alpha(strength < 1.0 ? 0 : 255);
    marks.push_back({role, std::nullopt,
                     Label{to_world(view.camera, upper_left), Vector<2>(0.0), std::move(words), style,
                           faded(colour, strength), halo}});
  }
  // Trails and grid run on below it.
  void backdrop(const ScreenBox& box) const {
    marks.push_back({role, std::nullopt,
                     Box{to_world(view.camera, box.least), box.extent(), view.points(4.0),
                         faded(view.theme.background, strength), view.theme.background.with_alpha(0), 0.0}});
  }
};

}  // namespace ghostforce
