// StageCanvas: draws on the stage in points of the window and keeps what is drawn as marks, whose places are in the
// world; and the names of the words that it places. What a layer of the stage is handed. One thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/picture/camera.h"
#include "app/picture/label_placer.h"
#include "app/picture/label_search.h"
#include "app/picture/marks.h"
#include "app/picture/screen_box.h"
#include "app/picture/theme.h"

namespace ghostforce {

// The words of the stage. One thing has one set of words at a time.
struct StageLabel {
  // In the order of their importance.
  enum Id : LabelId {
    battery,  // in a bare scene
    hint,     // what a newcomer is asked to do
    guess,
    measured_hand,
    ghost,
    slide,
    handle,
    wall_share,
    hand,
    loop,
    expected_rest,
    expected_contact,
    motor,
    wall,
  };
};

// The whole device in a small picture of its own, where the scene shows only a part of it. It does not move.
struct DeviceInset {
  ScreenBox box;
  Vector<2> center;         // of what it shows [m]
  double points_per_metre;  // in it

  Vector<2> at(const Vector<2>& world) const {
    return 0.5 * (box.least + box.most) + to_screen_direction(world - center) * points_per_metre;
  }
};

struct StageCanvas {
  const Camera& camera;
  const Theme& theme;
  double unit;  // a point of the design
  Marks& marks;
  LabelPlacer& labels;

  double points(double of_design) const { return of_design * unit; }
  // Of a line: beamers want them thicker.
  double width(double of_design) const { return of_design * unit * theme.thickness; }
  Vector<2> at(const Vector<2>& world) const { return to_screen(camera, world); }

  void line(Role role, const Vector<2>& from, const Vector<2>& to, double line_width, Colour colour,
            const LinePattern& pattern = solid_line);
  // Joined pieces.
  void curve(Role role, const std::vector<Vector<2>>& corners, double line_width, Colour colour);
  // A coil spring whose turns open as it is drawn out; both ends are kept clear of labels.
  void coil(Role role, const Vector<2>& from, const Vector<2>& to, int turns, double line_width, Colour colour);
  // A circle of dashes.
  void ring(Role role, const Vector<2>& middle, double radius, double line_width, Colour colour);
  void disc(Role role, const Vector<2>& middle, double radius, Colour fill, Colour rim, double rim_width);
  void box(Role role, const ScreenBox& box, double radius, Colour fill, Colour rim, double rim_width);
  void text(Role role, const Vector<2>& corner, std::string words, const TextStyle& style, Colour colour,
            bool has_halo = true);
  // Lines of text, one below the other.
  void text(Role role, const Vector<2>& corner, const std::vector<std::string>& lines, const TextStyle& style,
            Colour colour, bool has_halo = true);
  // Words beside what they name, where there is room; with a line to it where they stand far from it. They are kept
  // until add_labels(), when all is known that they must not cover.
  void label(Role role, LabelRequest request, Colour colour) {
    roles_of_labels.push_back(role);
    colours_of_labels.push_back(colour);
    requests.push_back(std::move(request));
  }
  void add_labels();

  std::optional<DeviceInset> inset{};

  std::vector<Role> roles_of_labels{};
  std::vector<Colour> colours_of_labels{};
  std::vector<LabelRequest> requests{};
};

}  // namespace ghostforce
