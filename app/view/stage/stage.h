// The stage: one hand, one handle, one wall; the force as the wall's share and the ghost; two numbers, one true
// sentence, three buttons. From values to marks and to what can be pressed, and nothing else: it reads no clock, no
// device, no global, so the same input gives the same picture, in the window, in a PNG and in a test. Pure but for the
// memory of where labels stood, which is handed in.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "app/view/moment_history.h"
#include "app/view/panes.h"
#include "app/view/stage/landscape_layout.h"
#include "app/view/stage/ribbon_layer.h"
#include "app/view/stage/stage_labels.h"
#include "app/view/stage/stage_layout.h"
#include "app/view/stage/stage_moment.h"
#include "app/view/stage/stage_sentence.h"
#include "core/loop_energy.h"

namespace ghostforce {

// What a person can take hold of on the stage.
enum class StageGrip : std::uint8_t { none, motor, wall };

// One thing at a time for somebody who is new here; each is said where it is done.
enum class StageHint : std::uint8_t { drag, cure, motor };

// A guess of where the handle comes to rest.
struct StageGuess {
  std::optional<Vector<2>> at{};      // [m]; empty: nothing is guessed
  bool is_open = false;               // it can still be dragged, and the answer is hidden
  std::optional<double> missed_by{};  // after the answer [m]
};

// The energy of the circle that the hand goes round.
struct StageRound {
  std::vector<Vector<2>> loop{};  // the handle's way on its last turn [m]
  CircleReading reading{};
};

// Where the motor's rail and the wall can be taken hold of, in points of the window.
struct StageGrips {
  std::array<Vector<2>, 2> motor;
  std::optional<std::array<Vector<2>, 2>> wall;
};
StageGrips stage_grips(const Settings& settings, const StageMoment& moment, const Camera& camera,
                       const ScreenBox& scene, double unit);
inline constexpr double stage_grip_reach = 22.0;  // of the pointer round one [points of the design]

// A button of its own at the end of the row: what there is to do next, or the motors'.
struct StageCornerButton {
  StageAction action = StageCommand::keys;
  std::string words;
  bool is_alarming = false;  // motors may push
};

struct StageContent {
  const Settings& settings;  // of the moment that is shown
  StageMoment moment;
  const Theme& theme;
  const MeasureText& measure;
  SceneView shown;
  double reference_force;  // whose arrow has the usual length [N]
  Vector<2> size;          // of the window [points]
  double scale = 1.0;      // UI scale
  StageMode mode = StageMode::none;
  StageAudience audience{};
  std::optional<StageHint> hint{};
  StageGrip hovered_grip = StageGrip::none;
  std::optional<StageAction> hovered{};  // the button under the pointer
  bool has_grips = false;                // a person can take hold of motor and wall
  StageGuess guess{};
  int why_step = 0;
  std::optional<StageRound> round{};
  double landscape_dial = 0.0;
  const MomentHistory* moments = nullptr;   // of the ribbon; null: there is none
  std::optional<double> looks_back_to_s{};  // its cursor [s]
  std::optional<StageCornerButton> corner{};
  std::string_view warning{};  // what must be said instead of the sentence; may be empty
};

// The picture, and what of it a person can take hold of.
struct StagePicture {
  struct RibbonPlace {
    ScreenBox box;
    RibbonAxis axis;
  };
  Pane pane{};
  double unit = 1.0;  // a point of the design
  std::vector<StageButton> buttons{};
  ScreenBox scene{};                           // where a hand can be seen
  Vector<2> pivot{0.0};                        // that the motor's rail turns about [m]
  std::optional<StageGrips> grips{};           // empty: nothing can be turned
  std::optional<LandscapeLayout> landscape{};  // empty: there is no map
  std::optional<RibbonPlace> ribbon{};
};

// `interval_s`: since the picture before, which `memory` is of.
StagePicture compose_stage(const StageContent& content, StageLabelMemory& memory, double interval_s,
                           Marks earlier = {});

// A force for reference_force: what the naïve device pushes at rest where the scene's hand ends [N].
double reference_force_of(const Settings& settings, const Vector<2>& goal);

}  // namespace ghostforce
