// Action: what a person does, as a value, one struct for each thing. Keys, buttons, pointer, panels and dialogs make
// them; permit.h says what is allowed at the moment, and apply.h does it. What only the shell can do, as to write a
// file, is an Effect as well. Values; any thread.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "app/state/landscape.h"
#include "app/state/scene_parts.h"
#include "app/state/session.h"

namespace ghostforce {

// --- Hand, motor and wall ---

// By a key [m]. While a guess is open it is what moves; where a lesson lets nobody move the hand, its slider.
struct MoveHandBy {
  Vector<2> by{0.0};
};
// By the pointer, which holds the hand until it lets go.
struct MoveHandTo {
  Vector<2> goal{0.0};  // [m]
};
struct LetGoOfHand {};
// Of where the handle comes to rest.
struct MoveGuessTo {
  Vector<2> guess{0.0};  // [m]
};
struct TurnMotorTo {
  double angle = 0.0;  // [rad]
};
struct TurnWallTo {
  double angle = 0.0;  // of its normal [rad]
};
// Wall and hand are those of that place on the map.
struct GoToLandscapePoint {
  LandscapePoint point;
};
// To whole steps, so that holding a key down runs through round angles.
struct TurnMotorBy {
  int degrees = 0;
};
struct TurnWallToLargestDrift {};
// Of a scene with more than one straight wall and one straight motor.
struct MovePart {
  ScenePart part = ScenePart::left_base;
  Vector<2> to{0.0};  // [m]
};
// To the other joint that may have it.
struct SwitchMotor {};
// Of a device whose motors push alone or together. Together they make it fully actuated.
struct UseMotors {
  MotorsInUse motors = MotorsInUse::first;
};
struct TurnRatio {
  double factor = 1.0;  // 1.05 for 5 % more
};

// --- Strategies ---

struct ChooseStrategy {
  StrategyId id;
  bool slowly = false;  // the stage takes 6 s for it instead of 0.6
};
// The answer of that number where a lesson asks for it, else the strategy.
struct ChooseByNumber {
  StrategyId id;
};

// On the landscape, between two strategies; the nearer one becomes the active one.
struct TurnLandscapeDial {
  double cure = 0.0;  // 0: naïve, 1: anisotropic
};

// --- Time ---

// Also stops looking back.
struct TogglePause {};
// A tick, into what has been; and on, through that to its end and then through what has not been yet.
struct StepBack {};
struct StepOn {};
struct LookBackTo {
  std::optional<double> time_s{};  // model time; empty: now
};
struct Restart {
  bool with_scene_settings = false;
};

// --- Stage, lessons and the talk ---

struct ShowFace {
  Face face;
};
struct SwitchFace {};
// Begins it, or ends it where it is on.
struct ToggleMode {
  StageMode mode;
};
// The mode, or in a lesson its button.
struct MeasureHand {};
struct PressMeasuringButton {};
// Enter: a reading while the hand is measured on the workbench; else to go on.
struct Confirm {};
// The answer to a guess, the next step of Why? or of the lesson.
struct GoOn {};
// Of the lesson, or else of the talk that a clicker goes through; before its first and after its last nothing happens.
struct NextStep {};
struct PreviousStep {};
struct ToggleBlank {};
// The stage's menu; whatever else is done closes it.
struct ToggleMenu {};
struct ToggleNumbers {};
struct AnswerLesson {
  std::size_t answer = 0;
};
// Of the step that is shown.
struct MoveSliderTo {
  double value = 0.0;  // of the lesson's unit
};
struct NudgeSlider {
  double hundredths = 0.0;  // of its length
};
struct LeaveLesson {};
struct NextLanguage {};

// --- Motors ---

struct ArmMotors {};
// The arms of a device without a home of its own are where they count from, and held still there.
struct ConfirmZeroPose {};
struct StopMotors {};
struct AcknowledgeOff {};  // why they went off has been read
// Esc: motors off before all else; then what is open is closed.
struct Escape {};

// --- View and window ---

struct NextCompareMode {};
struct ToggleViewOption {
  bool ViewOptions::*option;
};
struct FitView {};
struct ZoomView {
  struct Place {
    Vector<2> at{0.0};  // [m]
    StrategyId pane;    // of those side by side
  };

  double factor = 1.0;           // above 1: closer
  std::optional<Place> place{};  // that stays where it is; empty: the middle
};
struct MoveView {
  Vector<2> by{0.0};  // [m]
};
// By these shares of the picture's width; what is seen goes the other way.
struct PanView {
  Vector<2> shares{0.0};
};
struct TogglePlots {};
struct NextTheme {};
struct ChangeTextSize {
  int steps = 0;  // of 5 %
};
struct UseUsualTextSize {};
struct OpenDialog {
  Dialog dialog;
};
// Closes it where it is open.
struct ToggleDialog {
  Dialog dialog;
};
struct ChooseInput {
  std::string name;  // of the input catalog
};

// --- Controls of panels and dialogs ---

// One thing of the session becomes what its control shows.
template <auto Session::*member>
struct Change {
  std::remove_reference_t<decltype(std::declval<Session&>().*member)> after;
};
using ChangeSpeed = Change<&Session::speed>;
using ChangeViewOptions = Change<&Session::options>;
using ChangeAppearance = Change<&Session::appearance>;
using ChangeMotion = Change<&Session::motion>;
// Not by a control, but by the system's own setting.
using FollowSystemMotion = Change<&Session::system_reduces_motion>;
using ChangePlots = Change<&Session::plots>;
using ChangeSafety = Change<&Session::safety>;
using ChangeSpaceMouse = Change<&Session::spacemouse>;
using ChooseLanguage = Change<&Session::language>;
using SwitchSpeech = Change<&Session::speaks>;
using InjectFault = Change<&Session::injected_fault>;
using AimAtTarget = Change<&Session::aims_at_target>;
// A control or a handle; until it is let go of its change is not complete.
struct HoldControl {
  bool is_held = false;
};

struct ChangeStiffnesses {
  Stiffnesses after;
};
// About the hand's k_u.
struct Believe {
  BeliefSource source;
  std::optional<double> k_u{};  // typed [N/m]; empty: the same as the hand's. Of other sources: nothing
};
struct StartMeasuring {};
struct TakeReading {};
struct CancelMeasuring {};
struct RevealHand {};
struct BelieveMeasurement {};
struct BeginCircleTest {};
struct EndCircleTest {};
struct ChangeCircle {
  CircleChoice after;
};
// The newest moment again, at the right edge of the plots.
struct FollowNewest {};
struct ForgetLessons {};
struct CloseDialog {};
struct CloseNotice {};
struct HideHints {};

// --- What the shell does ---

struct Quit {
  bool ends_visit = false;  // with the chord that visitors are not told
};
struct ToggleFullScreen {};
// The second window, in which the audience sees the stage alone.
struct ToggleAudience {};
struct Undo {};
struct Redo {};
struct OpenScene {
  std::string name_or_path;  // or a file of any other kind that can be opened
};
struct OpenLesson {
  std::string name_or_path;
};
struct DropFiles {
  std::vector<std::string> paths;  // at least one
};
struct SaveScene {
  std::string path;
};
// Of what is on the screen: the format is the file name's.
struct SavePicture {
  std::string path;
  int density = 1;          // pixels per pixel of the screen, PNG only
  bool scene_alone = true;  // without bars and panels, PNG only
};
// The last seconds of the stage, with pictures as large as the scene on the screen: the format is the file name's
// (app/files/clip_file.h).
struct SaveClip {
  std::string path;
  double seconds = 5.0;  // of model time
  double end_s = 0.0;    // of the last moment in it, model time
  int frames_per_second = 30;
};
// What the plots show, as numbers (.csv) or as a picture (.png, .svg, .pdf).
struct SavePlots {
  std::string path;
  bool whole_history = false;  // of the plots over time; else the times in sight
};
// What is on the screen, for the system's clipboard, as PNG.
struct CopyPicture {
  int density = 2;
  bool scene_alone = false;
};
// The live values, as text.
struct CopyValues {};
// What is shown, as a line; and to show what such a line describes.
struct CopySetUp {};
struct PasteSetUp {
  std::string line{};  // empty: what the clipboard holds
};
// To this page, with that line.
struct ShowLink {};
// To the words and controls beside the picture.
struct ShowControls {};
struct StartRecording {
  std::string path;
};
struct StopRecording {};
// To what a new person sees.
struct ResetPreferences {};

using Effect = std::variant<Quit, ToggleFullScreen, ToggleAudience, Undo, Redo, OpenScene, OpenLesson, DropFiles,
                            SaveScene, SavePicture, SaveClip, SavePlots, CopyPicture, CopyValues, CopySetUp, PasteSetUp,
                            ShowLink, ShowControls, StartRecording, StopRecording, ResetPreferences>;
using Effects = std::vector<Effect>;

using AnyAction = std::variant<
    MoveHandBy, MoveHandTo, LetGoOfHand, MoveGuessTo, TurnMotorTo, TurnWallTo, GoToLandscapePoint, TurnMotorBy,
    TurnWallToLargestDrift, MovePart, SwitchMotor, UseMotors, TurnRatio, ChooseStrategy, ChooseByNumber,
    TurnLandscapeDial, TogglePause, StepBack, StepOn, LookBackTo, Restart, ShowFace, SwitchFace, ToggleMode,
    MeasureHand, PressMeasuringButton, Confirm, GoOn, NextStep, PreviousStep, ToggleBlank, ToggleMenu, ToggleNumbers,
    AnswerLesson, MoveSliderTo, NudgeSlider, LeaveLesson, NextLanguage, ArmMotors, ConfirmZeroPose, StopMotors,
    AcknowledgeOff, Escape, NextCompareMode, ToggleViewOption, FitView, ZoomView, MoveView, PanView, TogglePlots,
    NextTheme, ChangeTextSize, UseUsualTextSize, OpenDialog, ToggleDialog, ChooseInput, HoldControl, ChangeSpeed,
    ChangeViewOptions, ChangeAppearance, ChangeMotion, FollowSystemMotion, ChangePlots, ChangeSafety, ChangeSpaceMouse,
    ChooseLanguage, SwitchSpeech, InjectFault, AimAtTarget, ChangeStiffnesses, Believe, StartMeasuring, TakeReading,
    CancelMeasuring, RevealHand, BelieveMeasurement, BeginCircleTest, EndCircleTest, ChangeCircle, FollowNewest,
    ForgetLessons, CloseDialog, CloseNotice, HideHints, Quit, ToggleFullScreen, ToggleAudience, Undo, Redo, OpenScene,
    OpenLesson, DropFiles, SaveScene, SavePicture, SaveClip, SavePlots, CopyPicture, CopyValues, CopySetUp, PasteSetUp,
    ShowLink, ShowControls, StartRecording, StopRecording, ResetPreferences>;

template <typename T, typename Variant>
inline constexpr bool is_one_of = false;
template <typename T, typename... Alternatives>
inline constexpr bool is_one_of<T, std::variant<Alternatives...>> = (std::is_same_v<T, Alternatives> || ...);

// One of them. What copies and ends any of a hundred kinds is compiled once, in action.cpp, instead of in every source.
struct Action : AnyAction {
  template <typename Kind>
  requires is_one_of<std::remove_cvref_t<Kind>, AnyAction> Action(Kind&& kind)
      : AnyAction(std::in_place_type<std::remove_cvref_t<Kind>>, std::forward<Kind>(kind)) {}
  Action(const Action& other);
  Action(Action&& other) noexcept;
  Action& operator=(const Action& other);
  Action& operator=(Action&& other) noexcept;
  ~Action();
};

// All others close the stage's menu. Escape does it by itself.
using LeavesMenuOpen = std::variant<ToggleMenu, Escape, LetGoOfHand, HoldControl, AcknowledgeOff, FollowSystemMotion>;

// To whom those who make Actions hand them. UI thread.
using ActionSink = std::function<void(const Action& action)>;

}  // namespace ghostforce
