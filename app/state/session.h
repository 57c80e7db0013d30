// Session: what the person at the window has loaded, changed and asked for. A value of the UI thread; what the person does
// changes it (action.h, apply.h), and so does time; the application sends it on. Nothing in here knows
// of a file, or of a device more than values that are told about it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/pane_views.h"
#include "app/picture/theme.h"
#include "app/picture/view.h"
#include "app/state/belief_source.h"
#include "app/state/stiffness_probe.h"
#include "app/state/lesson_progress.h"
#include "app/state/lesson_state.h"
#include "app/state/measurement.h"
#include "app/state/plot_view.h"
#include "app/state/stage_choice.h"
#include "app/state/stage_view.h"
#include "app/state/kiosk_visit_state.h"
#include "core/hand_reading.h"
#include "core/loop_energy.h"
#include "core/scene.h"
#include "device/report/input_choice.h"
#include "device/report/motor_report.h"
#include "device/report/readiness.h"
#include "device/report/spacemouse.h"

namespace ghostforce {

struct PanelContext;

// How the screen looks; kept from one run to the next.
struct Appearance {
  static constexpr double least_scale = 0.75;
  static constexpr double greatest_scale = 3.0;
  static constexpr double least_arrow_scale = 0.25;
  static constexpr double greatest_arrow_scale = 4.0;

  const Theme* theme = &theme_catalog().front();
  double scale = 1.0;        // of letters and lines, on top of the display's own
  double arrow_scale = 1.0;  // of forces in the workbench's scene

  friend bool operator==(const Appearance&, const Appearance&) = default;
};

// The window in front of the scene, if any.
enum class Dialog : std::uint8_t {
  none,
  help,
  doctor,
  lessons,
  open_scene,
  save_scene,
  save_picture,
  save_clip,
  save_plots,
  palette,
  reset_preferences  // the last one: app/shell/line_text.h walks them all
};

// What stands in the fields of the dialog that is open.
struct Form {
  Dialog belongs_to = Dialog::none;
  std::string path;
  int density = 2;
  bool scene_alone = false;
  bool whole_history = false;
  int clip_seconds = 5;
  double clip_end_s = 0.0;        // what was shown when the form was opened, model time
  std::size_t marked_scene = 0;   // of those that the program brings along, in their order
  std::size_t marked_lesson = 0;  // of the shipped lessons, in their order
  std::string sought;             // what was typed into the palette,
  std::size_t marked_action = 0;  // and of what was found, the one that Enter does
  bool asks_for_reset = false;    // of the progress in lessons: the question is on the screen
  std::string problem;            // why what was asked for last could not be done; empty: it could
  std::string suggestion;         // a path that may have been meant; empty: none is known
};

// What undo and redo would change, in words; empty: there is nothing.
struct UndoOffer {
  std::string undo;
  std::string redo;
};

// One thing to tell the person.
struct Notice {
  std::string words;
  bool is_problem = false;  // stays until it is dismissed
  double age_s = 0.0;
};

// The circle test, as the person wants it.
struct CircleTest {
  CircleChoice choice;
  std::string input_before{mouse_hand.name};  // to go back to
  bool is_on = false;                         // a circle is the input in use
  bool has_news = false;                      // its table has just appeared; who has brought it into sight clears it
};

struct Session {
  std::shared_ptr<const Scene> scene;                // as loaded; never null
  Settings settings;                                 // as changed since
  BeliefSource belief_source = BeliefSource::typed;  // of their believed k_u
  std::optional<double> measured_k_u;                // that was believed last because it was measured [N/m]
  double time_s = 0.0;                               // of the newest tick, model time
  Vector<2> goal{0.0};                               // where the person wants the goal [m]
  bool drags_goal = false;                           // the pointer holds the goal
  bool is_editing = false;                           // a control or a handle is held: its change is not complete yet
  Face face = Face::workbench;
  StageChoice stage;
  std::optional<LessonState> lesson;    // empty: there is none
  LessonProgress lesson_progress;       // in all lessons
  std::string language{"en"};           // of the stage and of lessons, of ISO 639-1
  std::optional<KioskVisit> kiosk_visit;// of the visitor's mode; empty: an ordinary run
  SceneView shown;                      // the part of the world in the workbench's picture,
  std::optional<PaneViews> pane_views;  // in its panes side by side; empty: the next picture fits them to its moment
  SceneView stage_shown;                // and in the stage's
  ViewOptions options;
  PlotView plots;
  Appearance appearance;
  std::set<std::string, std::less<>> folded_panels;  // by title
  bool offers_speech = true;                         // there is somebody who could read aloud
  bool speaks = false;                               // the stage's sentence is to be read aloud
  std::string speech_problem;                        // why nothing is spoken all the same; empty: nothing is wrong
  bool paused = false;
  double speed = 1.0;  // of model time against real time
  std::uint32_t steps_asked = 0;
  std::uint32_t restarts_asked = 0;
  std::uint32_t arms_asked = 0;        // motors on
  std::uint32_t offs_asked = 0;        // motors off
  std::uint32_t acknowledgements = 0;  // the person has read why they went off
  SafetyOptions safety;
  SpaceMouseSettings spacemouse;
  bool aims_at_target = false;  // the hand at a device is told to aim at a target on the wall
  UserMeasurement measurement;
  StiffnessProbe stiffness_probe;
  CircleTest circle_test;
  std::string injected_fault;          // of a virtual device, a name of loop.injected_faults; empty: as it was started
  std::string input{mouse_hand.name};  // who moves the goal, a name of the input catalog
  bool pointer_moves_goal = true;      // that input follows the mouse
  bool hand_is_simulated = false;      // though that input has motors
  bool motors_may_push = false;        // that input's; Esc turns them off and does nothing else
  std::string recording_path;          // in the panel's field; empty: a name is proposed when recording begins
  bool has_handles = false;            // there is a person who can take hold of wall and motor axis
  std::optional<std::size_t> hint;     // offered to somebody who is new here: the number of it in hint_catalog()
  Dialog dialog = Dialog::none;
  Form form;
  std::optional<Notice> notice;
  std::uint32_t preference_resets = 0;  // all preferences are as at first again
  std::optional<double> dial_turned_s;  // real time since ρ was turned, while the dial says whom it acts on
  UndoOffer undo_offer;
  // What waits for the application.
  std::optional<std::string> wanted_input;  // a name of the input catalog; empty: the one in use
  bool fits_view = false;                   // the face that is shown then shows everything
  int ticks_through_history = 0;            // to look at the moment so many ticks later; negative: earlier
};

inline Session session_of(const Scene& scene) {
  Session session;
  session.scene = std::make_shared<const Scene>(scene);
  session.settings = scene.settings;
  session.goal = scene.goal.points.back();
  session.shown = scene.view;
  session.stage_shown = stage_view_of(scene.settings, session.goal);
  return session;
}

// Under which the newest tick ran: the settings, with a hand that may have changed since the run began. For what is said
// about the present; what the person changes are the settings themselves.
inline Settings settings_now(const Session& session) noexcept {
  return settings_at(*session.scene, session.settings, session.time_s);
}

// The recording that is being made, or the last one.
struct RecordingReading {
  bool is_on = false;
  std::string path{};         // empty: there was none
  double seconds = 0.0;       // of model time
  std::uint64_t bytes = 0;    // written so far
  std::uint64_t dropped = 0;  // samples that were lost
};

// What the loop reports about itself, for the status bar.
struct LoopReading {
  static constexpr double lately_s = 10.0;  // of real time

  std::string_view input_title;
  double rate_hz = 0.0;
  // Ticks that came a period late or more, not counting those while a device is looked for or opened.
  std::uint64_t late_ticks = 0;
  std::uint64_t late_ticks_lately = 0;  // of them, in the last lately_s
  std::uint64_t dropped_samples = 0;
  std::uint64_t refused = 0;  // settings and moves that the loop could not take
  bool diverged = false;      // the settings made the simulation unstable; it waits for others
  std::span<const InputChoice> inputs{};
  std::string_view why_no_falcon{};   // is among them; empty: there is one
  std::string_view shader_problem{};  // why watched shaders are not in use; may be empty
  MotorReport motors{};               // of the input, and what watches over them
  HandReading hand{};                 // that moves the active device, as it is measured
  double hand_unknown_s = 0.0;        // model time since it was last known, or since the belief began to follow it
  std::vector<ReadinessStepState> readiness{};            // up to motors that push; empty: the input has none
  std::string device{};                                   // what these steps are of; may be empty
  std::string device_remark{};                            // what else is to be known about it; may be empty
  std::span<const InputChoice> injected_faults{};         // that a virtual device can be asked for; empty: it is none
  std::function<void(const PanelContext&)> draw_input{};  // what else the input shows in its panel; may be empty
  RecordingReading recording{};
  std::optional<CircleReading> circle{};  // if the circle is the input
  std::string refused_by_system{};        // what the operating system does not grant the loop; may be empty
};

// How long the turn of the circle is that the picture shows; empty until the first is complete [s].
inline std::optional<double> turn_to_show(const LoopReading& loop) noexcept {
  if (!loop.circle || loop.circle->turns == 0) return std::nullopt;
  return period_of(loop.circle->circle);
}

}  // namespace ghostforce
