// Session: what the person at the window has loaded, changed and asked for. What the person does changes it (action.h,
// apply.h), and so does time; the application sends it on. Nothing in here knows of a file, or of a device more than
// values that are told about it. LoopReading is what comes back from the loop. Values of the UI thread.
#pragma once

#include <array>
#include <cstddef>
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
#include "app/state/faces_and_modes.h"
#include "app/state/lesson.h"
#include "app/state/lesson_progress.h"
#include "app/state/measurement.h"
#include "app/state/stage_view.h"
#include "core/conventions.h"
#include "core/hand_estimator.h"
#include "core/loop_energy.h"
#include "core/scene.h"
#include "device/report/input_choice.h"
#include "device/report/loop_periods.h"
#include "device/report/motor_report.h"
#include "device/report/spacemouse.h"

namespace ghostforce {

// --- The parts of a session, in the order in which it has them ---

// What the person does on the stage.
struct StageChoice {
  StageMode mode = StageMode::none;
  bool switches_slowly = false;             // the strategy was chosen with Shift, or by a clicker's step
  std::optional<Vector<2>> guess{};         // of where the handle comes to rest, while predicting [m]
  bool guess_is_open = true;                // it can still be moved, and the answer is hidden
  std::uint32_t reveals_asked = 0;          // of the truth about the guess
  int why_step = 0;                         // 1 to 4, of Why?; 0: not begun
  std::optional<double> landscape_dial{};   // 0 naïve, 1 anisotropic, as it was dragged; empty: as the strategy has it
  std::optional<double> looks_back_to_s{};  // the moment of the last minute that is shown, model time; empty: now
  bool is_black = false;                    // the picture is hidden, as clickers do
  bool hides_numbers = false;               // to ask a room for them first
  bool shows_menu = false;
  std::optional<int> demo_step{};  // of the talk that a clicker goes through; empty: not begun
};

// How a step's question was answered. Shown: the answer was given away, without a score.
enum class LessonOutcome : std::uint8_t { open, right, wrong, shown };

struct LessonStepState {
  LessonOutcome outcome = LessonOutcome::open;
  std::optional<std::size_t> chosen{};  // of the answers, from 0
  std::optional<Vector<2>> guess{};     // of where the handle comes to rest [m]
  std::optional<double> missed_by{};    // its distance from there [m]

  friend bool operator==(const LessonStepState&, const LessonStepState&) = default;
};

// Where a person is in a lesson, what they have answered, and what they had on the screen before. lesson_guide.h
// changes it.
struct LessonState {
  // The hand on its way to where a step wants it.
  struct Glide {
    Vector<2> from{0.0};  // [m]
    Vector<2> to{0.0};
    Vector<2> last{0.0};  // where it has put the hand; a hand that is elsewhere has been taken hold of
    double elapsed_s = 0.0;
  };
  // What comes back when the lesson ends.
  struct Before {
    Settings settings;
    Vector<2> goal{0.0};
    SceneView stage_shown;
    Face face = Face::stage;
    double speed = 1.0;
    BeliefSource belief_source = BeliefSource::typed;
  };

  std::shared_ptr<const Lesson> lesson;  // never null
  std::size_t step = 0;                  // of the lesson's, from 0
  std::size_t furthest = 0;              // that was ever shown
  std::vector<LessonStepState> steps;    // as many as the lesson has
  bool is_finished = false;              // the person has gone on from the last step
  std::optional<Glide> glide{};
  double met_s = 0.0;  // for so long the conditions of the task have been met
  Before before{};
};

// The visitor's mode, in which lessons follow one another in a loop for whoever comes along. kiosk_visit.h changes it.
struct KioskVisit {
  std::vector<std::shared_ptr<const Lesson>> lessons;  // one at least
  std::string language;                                // with which each visit begins
  std::size_t lesson = 0;                              // of the lessons, the one that is shown
  bool has_visitor = false;                            // somebody has touched something since the start
  double untouched_s = 0.0;                            // since somebody last did
  double since_start_s = 0.0;
  std::optional<Vector<2>> handle{};  // of a device, where it was when somebody last moved it [m]
  std::uint32_t departures = 0;       // of visitors, since the program began

  // After the last one comes the first.
  const std::shared_ptr<const Lesson>& take_next_lesson() {
    lesson = (lesson + 1) % lessons.size();
    return lessons[lesson];
  }
};

enum class PlotTab : std::uint8_t { time, wall_angle, ratio, hand };

// What a tab is called in proposed file names.
constexpr std::string_view plot_tab_name(PlotTab tab) noexcept {
  constexpr std::array<std::string_view, 4> names{"over-time", "over-wall-angle", "over-ratio", "hand-over-time"};
  return names[static_cast<std::size_t>(tab)];
}

// What the tab shows has a time axis, and can be looked back at.
constexpr bool is_over_time(PlotTab tab) noexcept {
  return tab == PlotTab::time || tab == PlotTab::hand;
}

// What of the plots a person looks at.
struct PlotView {
  // What fits into the plots' memory at 1 kHz [s].
  static constexpr double longest_span_s = 65.0;
  static constexpr double shortest_span_s = 0.02;

  bool is_open = false;
  PlotTab tab = PlotTab::time;
  bool follows = true;  // the newest tick is at the right edge
  double from_s = 0.0;  // the times in sight; model time
  double to_s = 4.0;
  std::optional<double> cursor_s{};  // the time under the pointer

  double span_s() const noexcept { return to_s - from_s; }
  // Keeps the right edge.
  void set_span(double span_s) noexcept { from_s = to_s - span_s; }
};

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

// How much the stage moves by itself. Reduced: it shows nothing while nobody does anything, and goes from one picture to
// the next at once. The simulation is the same.
enum class ScreenMotion : std::uint8_t { as_system, full, reduced };

// The stage measures the hand once, because somebody asked for it. The tones sound (core/measuring_tones.h) until it is
// known how stiff the hand is, or the stage gives up and says why. Only model time in the wall counts.
// stiffness_probe_guide.h leads it. SI units.
struct StiffnessProbe {
  enum class Stage : std::uint8_t { off, running, done };
  // In the wall, without an answer.
  static constexpr double gives_up_after_s = 6.0;

  Stage stage = Stage::off;
  double filled = 0.0;  // of the time that it takes, 0 to 1
  // While it runs, what it waits for: no_contact, no_tones (the motors are off), none. Done: why nobody knows.
  HandUnknown why = HandUnknown::none;
  HandEstimate estimate{};               // done, and known
  std::optional<HandEstimate> before{};  // the last one that was known before this one

  bool has_left_wall = false;          // since it began
  double given_k_u = 0.0;              // of the simulated hand that was measured [N/m]
  double tried_s = 0.0;                // in the wall, since it began
  std::optional<double> seen_s{};      // model time of the last look; empty: it has not begun yet
  std::optional<double> pressing_s{};  // model time since which it is in the wall; empty: it is not

  bool is_running() const noexcept { return stage == Stage::running; }
  bool is_known() const noexcept { return stage == Stage::done && why == HandUnknown::none; }
};

// The circle test, as the person wants it.
struct CircleTest {
  CircleChoice choice;
  std::string input_before{mouse_hand.name};  // to go back to
  bool is_on = false;                         // a circle is the input in use
  bool has_news = false;                      // its table has just appeared; who has brought it into sight clears it
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
  bool awaits_place = false;  // of the system's own dialog, which is open
  int density = 2;
  bool is_at_left = false;  // of a dialog beside the hand: it stays where it was opened
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

// One thing to tell the person.
struct Notice {
  std::string words;
  bool is_problem = false;  // stays until it is dismissed
  double age_s = 0.0;
  std::string language{};  // code of that of its words; empty: the session's
};

// What undo and redo would change, in words; empty: there is nothing.
struct UndoOffer {
  std::string undo;
  std::string redo;
};

// --- The session ---

// Of a device whose two motors push alone or together.
enum class MotorsInUse : std::uint8_t { first, second, both };

struct MotorsInUseEntry {
  MotorsInUse id;
  std::string_view name;  // in the lines of a session
};
inline constexpr std::array motors_in_use_catalog{
    MotorsInUseEntry{MotorsInUse::first, "first"},
    MotorsInUseEntry{MotorsInUse::second, "second"},
    MotorsInUseEntry{MotorsInUse::both, "both"},
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
  std::optional<LessonState> lesson;      // empty: there is none
  LessonProgress lesson_progress;         // in all lessons
  std::string lesson_gone_through;        // last, in this run: its progress_key(); empty: none
  std::string language{"en"};             // of the stage and of lessons, of ISO 639-1
  std::optional<KioskVisit> kiosk_visit;  // of the visitor's mode; empty: an ordinary run
  SceneView shown;                        // the part of the world in the workbench's picture,
  std::optional<PaneViews> pane_views;    // in its panes side by side; empty: the next picture fits them to its moment
  SceneView stage_shown;                  // and in the stage's
  ViewOptions options;
  PlotView plots;
  Appearance appearance;
  std::shared_ptr<const Theme> system_theme;  // in place of the chosen one, where the system forces its colours
  ScreenMotion motion = ScreenMotion::as_system;
  bool system_reduces_motion = false;                // what the desktop or the browser says about it
  std::set<std::string, std::less<>> folded_panels;  // by title
  bool has_room_for_workbench = true;                // the window is not a phone's
  bool offers_full_screen = true;
  bool offers_audience = true;  // there can be a second window,
  bool has_audience = false;    // in which the audience sees the stage alone
  bool offers_speech = true;    // there is somebody who could read aloud
  bool speaks = false;          // the stage's sentence is to be read aloud
  std::string speech_problem;   // why nothing is spoken all the same; empty: nothing is wrong
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
  bool has_motors = false;             // that input
  bool motors_may_push = false;        // its motors; Esc turns them off and does nothing else
  bool motor_line_turns = false;       // the line of its motor turns with the handle: the device says where it is
  std::uint32_t zero_poses_confirmed = 0;  // how often a person has said that the device's arms are in their zero pose
  std::size_t device_motor = 0;            // of a device with two, the one that pushes alone, 0 or 1
  std::string recording_path;              // in the panel's field; empty: a name is proposed when recording begins
  bool has_handles = false;                // there is a person who can take hold of wall and motor axis
  std::optional<std::size_t> hint;         // offered to somebody who is new here: the number of it in hint_catalog()
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

// That the screen has.
inline const Theme& shown_theme(const Session& session) noexcept {
  return session.system_theme ? *session.system_theme : *session.appearance.theme;
}

inline bool reduces_motion(const Session& session) noexcept {
  return session.motion == ScreenMotion::reduced ||
         (session.motion == ScreenMotion::as_system && session.system_reduces_motion);
}

// As it begins with this scene.
inline Session session_of(const Scene& scene) {
  Session session;
  session.scene = std::make_shared<const Scene>(scene);
  session.settings = scene.settings;
  session.goal = scene.goal.points.back();
  session.shown = scene.view;
  session.stage_shown = stage_view_of(scene.settings, session.goal);
  return session;
}

// The settings under which the newest tick ran, with a hand that may have changed since the run began. For what is said
// about the present; what the person changes are the settings themselves.
inline Settings settings_now(const Session& session) noexcept {
  return settings_at(*session.scene, session.settings, session.time_s);
}

// --- What the loop reports ---

struct PanelContext;

// The recording that is being made, or the last one.
struct RecordingReading {
  bool is_on = false;
  std::string path{};         // empty: there was none
  double seconds = 0.0;       // of model time
  std::uint64_t bytes = 0;    // written so far
  std::uint64_t dropped = 0;  // samples that were lost
};

// How far a session is that is done again.
struct ReplayPlace {
  std::size_t done = 0;  // of its actions
  std::size_t all = 0;
  bool is_over = false;  // whoever has watched has the window to themselves now
};

// What the loop reports about itself, for the status bar.
struct LoopReading {
  static constexpr double lately_s = 10.0;  // of real time

  std::string_view input_title;
  double rate_hz = 0.0;
  // Ticks that came a period late or more, not counting those while a device is looked for or opened.
  std::uint64_t late_ticks = 0;
  std::uint64_t late_ticks_lately = 0;  // of them, in the last lately_s
  LoopPeriods periods{};                // since the input was chosen
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
  std::optional<ReplayPlace> replay{};    // empty: it is no replay
};

// How long the turn of the circle is that the picture shows; empty until the first is complete [s].
inline std::optional<double> turn_to_show(const LoopReading& loop) noexcept {
  if (!loop.circle || loop.circle->turns == 0) return std::nullopt;
  return period_of(loop.circle->circle);
}

}  // namespace ghostforce
