// The layers of the workbench's picture, back to front; each appends its marks.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "app/picture/label_placer.h"
#include "app/picture/marks.h"
#include "app/picture/screen_box.h"
#include "app/picture/view.h"

namespace ghostforce {

void add_wall(const View& view, Marks& marks);         // grid, wall, hatching
void add_mechanism(const View& view, Marks& marks);    // links, joints and strings of the active device
void add_trails(const View& view, Marks& marks);       // where goal and devices have been
void add_hand(const View& view, Marks& marks);         // the spring from the goal to the active device
void add_loop(const View& view, Marks& marks);         // the active device's last turn of the circle test
void add_goal(const View& view, Marks& marks);         // where the hand pulls to
void add_predictions(const View& view, Marks& marks);  // where the closed form says that the active device rests
void add_others(const View& view, Marks& marks);       // the strategies that are not active: pale, and without words
void add_target(const View& view, Marks& marks);       // where the hand at a device is to aim
// Of the active strategy.
void add_proxy(const View& view, Marks& marks);  // and its contact
void add_drift(const View& view, Marks& marks);  // the proxy drift, as a ruler
void add_force(const View& view, Marks& marks);  // the rendered force, its ghost hatched
void add_device(const View& view, Marks& marks);
void add_goal_in_device(const View& view, Marks& marks);  // a dot, where the device covers the goal
void add_handles(const View& view, Marks& marks);         // dial of the actuated direction, wall grips

// What stands beside the scene, and the words: they need to know of all the marks above.
void keep_marks_clear(const View& view, const Marks& marks, LabelPlacer& labels);
void add_legend(const View& view, LabelPlacer& labels, CornerMemory& memory, Marks& marks);  // or a pane's title
void add_scales(const View& view, LabelPlacer& labels, CornerMemory& memory, Marks& marks);
void add_dial_caption(const View& view, LabelPlacer& labels, Marks& marks);
void add_labels(const View& view, LabelPlacer& labels, Marks& marks);

// --- Where layers must agree -----------------------------------------------------------------------------------------

// Draws what has its place on the screen, not in the world.
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

// Smaller drifts are not drawn [m].
inline constexpr double smallest_drift = 0.0002;

// The force of the active strategy along one line from its device, in points of the picture.
struct DrawnForce {
  Vector<2> start;
  Vector<2> direction;  // on the screen
  double share;         // length of what the fully actuated rendering would push along the motors, too
  double ghost;         // of the ghost force; negative: it folds back over the share

  Vector<2> share_end() const { return start + direction * share; }
  Vector<2> tip() const { return start + direction * (share + ghost); }
};
// Empty in free space, and where it is too short to be seen.
std::optional<DrawnForce> drawn_force(const View& view);
inline constexpr double force_arrow_width = 8.0;  // [points]
inline constexpr double device_radius = 9.0;

// Along the wall on its free side, clear of everything in the wall: from beside where the wall should hold the proxy to
// beside where it does.
struct Ruler {
  Vector<2> from;  // [m]
  Vector<2> to;
  Vector<2> foot;   // what its first end belongs to, and is led to by a thin line
  Vector<2> other;  // and its second
};
std::optional<Ruler> drift_ruler(const View& view);

// Of what belongs to a strategy that is not active.
Colour pale_colour(const Theme& theme, StrategyId id) noexcept;

// How far a marker reaches from its middle, without its rim, as a share of its radius; as the painters draw it.
double reach_of(Shape shape) noexcept;

}  // namespace ghostforce
