// The layers of the stage, back to front; each appends its marks and says what no label may cover.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/stage/landscape_layout.h"
#include "app/stage/lesson_layout.h"
#include "app/stage/stage_canvas.h"
#include "app/stage/stage_content.h"
#include "core/scene_shape.h"

namespace ghostforce {

struct Ribbon;

struct StageLayer {
  const StageContent& content;
  const StageLayout& layout;
  StageCanvas& canvas;
};

void add_stage_wall(const StageLayer& layer);    // wall, hatching, grips
void add_mechanism(const StageLayer& layer);     // links, joints, strings; the hand's ellipse
void add_part_grips(const StageLayer& layer);    // what of a general scene can be moved
void add_device_inset(const StageLayer& layer);  // the whole device, small, where the scene shows a part of it
void add_rail(const StageLayer& layer);          // along which the motors push
void add_expectations(const StageLayer& layer);  // where the wall should hold and the handle should rest
void add_springs(const StageLayer& layer);       // the hand's and the wall's
void add_stage_hand(const StageLayer& layer);    // fist and goal
void add_stage_force(const StageLayer& layer);   // the wall's share and the ghost
void add_slide(const StageLayer& layer);         // the ruler along the wall
void add_handle(const StageLayer& layer);        // handle and proxy
void add_rail_grips(const StageLayer& layer);    // over all that may lie over the rail's ends
void add_stage_words(const StageLayer& layer);   // beside all these,
void add_hand_words(const StageLayer& layer);    // and beside some
void add_motor_words(const StageLayer& layer);
// While it is to be guessed where the handle is, the rail lies through the hand, and tells nothing.
bool hides_rest(const StageContent& content);
StageMoment moment_of_question(const StageContent& content);
void keep_guess_clear(const StageLayer& layer);
void add_guess(const StageLayer& layer);  // of where the handle comes to rest, if there is one
// So that what is below words does not run through them.
void add_plate(const StageLayer& layer, Role role, const ScreenBox& words, double strength);
inline constexpr double under_sentences = 0.85;      // its strength
void add_sentence(const StageLayer& layer);          // above
void add_place_of_numbers(const StageLayer& layer);  // which labels leave free
void add_numbers(const StageLayer& layer);
void add_buttons(const StageLayer& layer);       // above at the right, and below
void add_overlays(const StageLayer& layer);      // over all: the menu, and what is said of what is under the pointer
void add_lesson_frame(const StageLayer& layer);  // title, answers, slider, back and next
void keep_frame_clear(const StageLayer& layer);  // of labels: sentence and buttons

void keep_lesson_clear(const StageLayer& layer);
std::vector<StageButton> lesson_buttons(const LessonLayout& places);  // that can be pressed, but for the way out

// What a mode draws and says instead, where it does. One file a mode.
struct StageModeLayers {
  StageMode id;
  void (*add)(const StageLayer& layer);                  // the scene
  std::string (*sentence)(const StageContent& content);  // empty: the moment's own
};
extern const StageModeLayers predict_layers;
extern const StageModeLayers why_layers;
extern const StageModeLayers landscape_layers;
extern const StageModeLayers round_layers;
extern const StageModeLayers ribbon_layers;
extern const StageModeLayers measure_layers;

// All things of the scene and the words beside them.
void add_whole_scene(const StageLayer& layer);
// The map of a device with joints: of which the walls are bad, over its workspace.
inline bool maps_workspace(const StageContent& content) {
  return content.mode == StageMode::landscape && has_joints(content.settings);
}
void add_workspace(const StageLayer& layer);
std::string workspace_sentence(const StageContent& content);
// Where the device's small picture stands: a place of its own, whatever moves. Empty: there is no room.
std::optional<ScreenBox> place_of_device(const StageLayout& layout);
LandscapeView stage_landscape(const StageContent& content, const Camera& camera, const LandscapeRoom& room);
// "ghost 1.27 N", or without the number where it is hidden.
std::string with_number(const StageContent& content, std::string_view words, const std::string& number,
                        std::string_view unit);
// What Why? says beside its forces, in as many steps as it has come to.
std::vector<std::string> why_steps(const StageContent& content);
// Beside the hand, in lines; empty: nothing.
std::vector<std::string> measured_hand_words(const StageMeasuring& measuring, const StageLanguage& language);
// Empty where there is none.
std::optional<Ribbon> stage_ribbon(const StageLayer& layer);

// --- Where layers must agree -----------------------------------------------------------------------------------------

// A colour mixed of the strategies' own, by their weights.
Colour stage_colour(const StageMoment& moment, const PerStrategy<Colour>& colours);
// How a force is drawn along one line, in points from the handle's middle.
struct ForceArrow {
  Vector<2> start;            // of the wall's share
  Vector<2> direction;        // on the screen
  double share;               // length of the wall's share
  double ghost;               // of the ghost force; negative: it folds back over the share
  Vector<2> ghost_direction;  // of several motors it may be another
  bool turns() const { return ghost_direction != direction; }
  Vector<2> share_end() const { return start + direction * share; }
  Vector<2> tip() const {
    return turns() ? share_end() + ghost_direction * ghost : start + direction * (share + ghost);
  }
};
std::optional<ForceArrow> force_arrow(const StageLayer& layer);

// The slide as a ruler on the free side of the wall.
struct SlideRuler {
  Vector<2> from;  // beside where the wall should hold
  Vector<2> to;    // beside the proxy
  Vector<2> out;   // away from the wall, on the screen
  // Beside a round wall it is an arc, which ends across this direction.
  std::vector<Vector<2>> arc{};
  Vector<2> out_at_end{0.0};
};
std::optional<SlideRuler> slide_ruler(const StageLayer& layer);

// A straight wall without its edge, and where the edge is, in points.
struct StageEdge {
  Vector<2> from;
  Vector<2> to;
};
StageEdge add_half_plane(const StageLayer& layer, const Wall<2>& wall);
void add_shaped_wall(const StageLayer& layer);                                // a corner, or a round one
void add_pulls(const StageLayer& layer, const MotorReach& motors);            // the cone of what strings can do
void add_knob(const StageLayer& layer, const Vector<2>& place, bool is_hot);  // to move or turn something by
void add_wall_grips(const StageLayer& layer);                                 // by which it can be turned
// The edge of any wall in a part of the picture that has a view of its own; `width` of the design.
void add_edge_in(const StageLayer& layer, const DeviceInset& part, Role role, double width, Colour colour);
std::vector<StagePart> stage_parts(const StageLayer& layer);
SlideRuler round_ruler(const StageLayer& layer, const Vector<2>& from, const Vector<2>& out);

// How far handle and proxy reach from their middle, whatever their shape, without their rim.
double shape_reach(const StageMoment& moment, double radius);

inline constexpr double handle_radius = 17.0;  // [points of the design]
inline constexpr double target_radius = 13.0;
inline constexpr double arrow_width = 14.0;
inline constexpr double measuring_ring = 62.0;  // round the hand, its radius

}  // namespace ghostforce
