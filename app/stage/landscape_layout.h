// Where the landscape's map, its dial and its words lie in a picture: what is drawn and what the pointer takes hold of
// come from here. Screen points, y down. Pure, any thread; finite for any size.
//
// All of it stays clear of what the stage has round it: above at the right, and below.
#pragma once

#include <cstdint>

#include "app/picture/camera.h"
#include "app/picture/screen_box.h"
#include "app/picture/theme.h"
#include "app/picture/view.h"
#include "app/state/landscape.h"
#include "app/state/stage_language.h"

namespace ghostforce {

// What the stage leaves to the landscape [points].
struct LandscapeRoom {
  ScreenBox header;     // stands above at the right, up to the edges
  double bottom = 0.0;  // where the buttons begin
};

// All that is needed to draw one picture of the landscape. Read only.
struct LandscapeView {
  const Settings& settings;
  double dial;           // from 0, naïve, to 1: what anisotropic rendering runs with
  bool has_every_motor;  // then there is no ghost force anywhere, and no dial
  const StageLanguage& language;
  const Theme& theme;
  Camera camera;
  double scale;  // UI scale, 1 is normal
  const MeasureText& measure;
  LandscapeRoom room;
};

// In em: a line of text, from the highest to the lowest letter; and from the map's frame to its numbers, so that the
// ring may stand on the frame.
inline constexpr double line_height = 1.17;
inline constexpr double beside_map = 0.85;

struct LandscapeLayout {
  Vector<2> size{1.0};  // of the picture
  double em = 1.0;      // of its smallest letters: 1/30 of the height, times the unit as far as it fits
  ScreenBox map;        // θ to the right, log κ upwards
  ScreenBox column;     // words and dial, to its left
  ScreenBox scale;      // of the colours, to its right; its numbers follow
  ScreenBox dial;       // the way of the knob's middle, naïve at its left end
  double axis_title_top = 0.0;
  double ring_radius = 1.0;
  double knob_radius = 1.0;
};

// `unit`: the UI scale times the theme's thickness. Pictures that are narrower than 4:3 have smaller letters.
LandscapeLayout landscape_layout(const Vector<2>& size, double unit, const LandscapeRoom& room) noexcept;
// As add_landscape() draws it.
inline LandscapeLayout landscape_layout(const LandscapeView& view) noexcept {
  return landscape_layout(view.camera.size, view.scale * view.theme.thickness, view.room);
}

// The nearest place on the map, for a set-up that lies beyond it.
Vector<2> ring_at(const LandscapeLayout& layout, const LandscapePoint& point) noexcept;
// The nearest set-up of the map, for a pointer that has left it.
LandscapePoint landscape_point_under(const LandscapeLayout& layout, const Vector<2>& screen) noexcept;
bool is_on_map(const LandscapePoint& point) noexcept;

Vector<2> knob_at(const LandscapeLayout& layout, double dial) noexcept;
double dial_under(const LandscapeLayout& layout, const Vector<2>& screen) noexcept;

// What a press takes hold of. The ring comes to wherever on the map one presses.
enum class LandscapeHandle : std::uint8_t { none, ring, dial };
LandscapeHandle landscape_handle_under(const LandscapeLayout& layout, const Vector<2>& screen) noexcept;

}  // namespace ghostforce
