// StageContent: all that the stage is drawn from, and StageFrame, from which a frame of it is made. Values, read only;
// any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/moment_history.h"
#include "app/picture/theme.h"
#include "app/picture/view.h"
#include "app/stage/stage_layout.h"
#include "app/stage/stage_lesson.h"
#include "app/stage/stage_places.h"
#include "app/stage/stage_sentence.h"
#include "app/state/scene_parts.h"
#include "app/state/session.h"
#include "app/state/stage_language.h"
#include "app/state/stage_moment.h"
#include "core/loop_energy.h"
#include "core/mechanism.h"

namespace ghostforce {

// What a person can take hold of on the stage.
enum class StageGrip : std::uint8_t { none, motor, wall, part };

// One thing at a time for somebody who is new here; each is said where it is done.
enum class StageHint : std::uint8_t { drag, cure, motor };

// What can be moved of a general scene, where it is seen.
struct StagePart {
  PlacedPart placed{};
  Vector<2> place{0.0};           // [points]
  double points_per_metre = 1.0;  // there
};

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

// A button of its own at the end of the row: what there is to do next, or the motors'.
struct StageCornerButton {
  StageAction action = StageCommand::next;
  std::string words;
  bool is_alarming = false;  // motors may push
};

// What is held of the rail, the wall or a part of the scene: it comes to the pointer as far as it can be seen there.
struct HeldEnd {
  StageGrip grip = StageGrip::none;
  Vector<2> pointer{0.0};  // [points]
};

struct StageContent {
  const Settings& settings;  // of the moment that is shown
  StageMoment moment;
  const StageLanguage& language;
  StageKeys keys;
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
  bool is_dragging = false;  // something is held, and the view stands still
  std::optional<HeldEnd> held_end{};
  std::optional<StageAction> hovered{};  // the button under the pointer
  bool may_turn_motor = false;           // by its ends
  // What its rail goes through wherever it is turned to, once everything has come to rest; empty: the handle [m].
  std::optional<Vector<2>> rail_pivot{};
  bool may_turn_wall = false;
  bool may_move_parts = false;                 // of a general scene: the ends of its device and its walls
  std::optional<ScenePart> hovered_part{};     // with hovered_grip part
  std::optional<LinkagePose> linkage{};        // of a real device; empty: the settings say what there is
  bool handle_is_unknown = false;              // of a real device; its links are then where they are to be put
  std::optional<MotorsInUse> motors_in_use{};  // of that device, where they can be chosen
  StageGuess guess{};
  int why_step = 0;
  std::optional<StageRound> round{};
  double landscape_dial = 0.0;
  std::optional<StageMeasuring> measuring{};               // of the hand; empty: nobody has asked for it
  std::optional<StageMeasuringButton> measuring_button{};  // empty: the hand is not being measured, and cannot be
  const MomentHistory* moments = nullptr;                  // of the ribbon; null: there is none
  std::optional<double> looks_back_to_s{};                 // its cursor [s]
  std::optional<StageCornerButton> corner{};
  std::optional<StageLesson> lesson{};
  StageSecrets hides{};
  std::string warning{};     // what must be said instead of the sentence; may be empty
  std::string remark{};      // so too, where nothing is wrong and neither a lesson nor a mode speaks
  bool is_bare = false;      // the scene alone: no sentence, no large numbers, no buttons round it
  bool has_controls = true;  // else the buttons are left out, but for a lesson's: nobody can press them in a picture
  bool shows_menu = false;
  SentenceWidths* widths = nullptr;  // see StageFrameWords
};

// What a frame of the stage is made from. It refers to what others hold for as long as the frame lasts.
struct StageFrame {
  const ShownMoment& shown;
  const History& history;
  const LoopReading& loop;
  const Theme& theme;
  const MeasureText& measure;
  Vector<2> size;        // of the window [points]
  double scale;          // UI scale
  bool is_bare = false;  // see StageContent
  bool has_controls = true;
};

}  // namespace ghostforce
