#include "app/state/permit.h"

#include <algorithm>

#include "app/state/lesson_guide.h"
#include "app/state/user_measurement_guide.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

using Permission = std::optional<Refusal>;

using Why = StageLanguage::Refusals;
// Of what has no row in the palette, and of what visitors have no way to: nobody reads it.
constexpr Refusal has_no_meaning{&Why::has_no_meaning};
constexpr Refusal left_to_lesson{&Why::left_to_lesson};
constexpr Refusal plots_left_to_lesson{&Why::left_to_lesson, true};
constexpr Refusal needs_larger_window{&Why::needs_larger_window, true};
constexpr Refusal not_in_this_step{&Why::not_in_this_step};
constexpr Refusal not_measured{&Why::not_measured};
constexpr Refusal only_on_workbench{&Why::only_on_workbench};
constexpr Refusal view_of_its_own{&Why::view_of_its_own};
constexpr Refusal measurement_sets_it{&Why::measurement_sets_it};
constexpr Refusal curves_are_hidden{&Why::curves_are_hidden, true, true};
constexpr Refusal measures_otherwise{&Why::measures_otherwise, true};
constexpr Refusal not_with_this_device{&Why::not_with_this_device, true};
constexpr Refusal tones_need_one_line{&Why::tones_need_one_line, true};
constexpr Refusal leaves_device{&Why::leaves_device, true};
constexpr Refusal line_follows_handle{&Why::line_follows_handle, true};

// A visitor has no way to files, settings or the window.
using ForVisitors =
    std::variant<MoveHandBy, MoveHandTo, LetGoOfHand, MoveGuessTo, TurnMotorTo, TurnWallTo, MovePart, SwitchMotor,
                 GoToLandscapePoint, TurnLandscapeDial, LookBackTo, MoveSliderTo, NudgeSlider, TurnMotorBy,
                 ChooseStrategy, ChooseByNumber, PressMeasuringButton, Confirm, GoOn, NextStep, PreviousStep,
                 AnswerLesson, NextLanguage, ArmMotors, ConfirmZeroPose, StopMotors, AcknowledgeOff, Escape,
                 HoldControl, FollowSystemMotion, Quit>;

// A lesson tells its own time, says which mode is on and what moves the hand, and leaves nothing to undo.
using LeftToLesson = std::variant<TurnRatio, TogglePause, StepBack, StepOn, ShowFace, SwitchFace, ToggleMode,
                                  ToggleMenu, ChooseInput, BeginCircleTest, EndCircleTest, StartMeasuring, Undo, Redo>;

Permission refuse_unless(bool is_allowed, const Refusal& refusal) {
  return is_allowed ? std::nullopt : Permission(refusal);
}

Permission permit_control(const Session& session, LessonControl control) {
  return refuse_unless(is_allowed(session, control), not_in_this_step);
}

Permission permit_slider(const Session& session) {
  const bool has_slider = session.lesson && lesson_step(*session.lesson).slider;
  return refuse_unless(has_slider, not_in_this_step);
}

// What is made for the paper's scenes alone.
Permission permit_paper(const Session& session) {
  return refuse_unless(!is_general(session.settings), not_with_this_device);
}

// The mode would show what a blind measurement hides.
Permission permit_probe(const Session& session) {
  if (const auto refusal = permit_paper(session)) return refusal;
  if (session.motor_line_turns) return tones_need_one_line;
  return refuse_unless(!is_measuring(session) && !hides_answer(session), measures_otherwise);
}

// One direction, wherever the handle is.
Permission permit_motor(const Session& session) {
  if (session.motor_line_turns) return line_follows_handle;
  if (session.settings.general.mechanism != MechanismKind::axes) return not_with_this_device;
  return permit_control(session, LessonControl::motor);
}

// One straight wall.
Permission permit_wall(const Session& session) {
  if (session.settings.general.constraint != ConstraintKind::plane) return not_with_this_device;
  return permit_control(session, LessonControl::wall);
}

// What an action needs besides; most need nothing.
template <typename A>
Permission permit_kind(const Session& /*session*/, const A& /*action*/) {
  return std::nullopt;
}

Permission permit_kind(const Session& session, const MoveHandBy&) {
  if (session.stage.guess && session.stage.guess_is_open) return std::nullopt;
  if (is_allowed(session, LessonControl::hand)) return refuse_unless(session.pointer_moves_goal, has_no_meaning);
  return permit_slider(session);
}

Permission permit_kind(const Session& session, const MoveHandTo&) {
  if (!is_allowed(session, LessonControl::hand)) return not_in_this_step;
  return refuse_unless(session.pointer_moves_goal, has_no_meaning);
}

Permission permit_kind(const Session& session, const MoveGuessTo&) {
  return refuse_unless(session.stage.guess && session.stage.guess_is_open, has_no_meaning);
}

Permission permit_kind(const Session& session, const TurnMotorTo&) {
  return permit_motor(session);
}

Permission permit_kind(const Session& session, const TurnWallTo&) {
  return permit_wall(session);
}

// A place on the map is a wall and a stiffness.
Permission permit_kind(const Session& session, const GoToLandscapePoint&) {
  if (session.stage.mode != StageMode::landscape) return has_no_meaning;
  return permit_control(session, LessonControl::wall);
}

// With every motor there is no dial.
Permission permit_kind(const Session& session, const TurnLandscapeDial&) {
  if (session.stage.mode != StageMode::landscape || session.settings.active == StrategyId::full) return has_no_meaning;
  return permit_control(session, LessonControl::strategies);
}

Permission permit_kind(const Session& session, const MoveSliderTo&) {
  return permit_slider(session);
}

Permission permit_kind(const Session& session, const NudgeSlider&) {
  return permit_slider(session);
}

Permission permit_kind(const Session& session, const TurnMotorBy&) {
  return permit_motor(session);
}

Permission permit_kind(const Session& session, const TurnWallToLargestDrift&) {
  if (const auto refusal = permit_paper(session)) return refusal;
  return permit_control(session, LessonControl::wall);
}

Permission permit_kind(const Session& session, const MovePart& action) {
  const auto has = [&](const PlacedPart& part) { return part.part == action.part && !part.stays; };
  if (std::ranges::none_of(scene_parts(session.settings, session.goal, 0.0), has)) return has_no_meaning;
  return permit_control(session, is_of_wall(action.part) ? LessonControl::wall : LessonControl::motor);
}

Permission permit_kind(const Session& session, const SwitchMotor&) {
  if (!session.motor_line_turns && !has_joints(session.settings)) return not_with_this_device;
  return permit_control(session, LessonControl::motor);
}

Permission permit_kind(const Session& session, const UseMotors&) {
  return session.motor_line_turns ? permit_control(session, LessonControl::motor) : not_with_this_device;
}

Permission permit_kind(const Session& session, const TurnRatio&) {
  return permit_paper(session);
}

Permission permit_kind(const Session& session, const ChooseStrategy&) {
  return permit_control(session, LessonControl::strategies);
}

Permission permit_kind(const Session& session, const ChooseByNumber&) {
  if (has_open_question(session, LessonQuestion::choose)) return std::nullopt;
  return permit_control(session, LessonControl::strategies);
}

Permission permit_kind(const Session& session, const AnswerLesson&) {
  return refuse_unless(has_open_question(session, LessonQuestion::choose), has_no_meaning);
}

// A lesson's step can begin anew, and with its own settings.
Permission permit_kind(const Session& session, const Restart& action) {
  return refuse_unless(!session.lesson || !action.with_scene_settings, left_to_lesson);
}

Permission permit_kind(const Session& session, const ToggleMode& action) {
  if (action.mode == StageMode::landscape && !has_joints(session.settings)) return permit_paper(session);
  if (action.mode == StageMode::round && session.motor_line_turns) return leaves_device;
  return action.mode == StageMode::measure ? permit_probe(session) : std::nullopt;
}

// In a lesson the step says whether there is something to measure.
Permission permit_kind(const Session& session, const MeasureHand&) {
  if (!session.lesson) return permit_probe(session);
  return refuse_unless(session.stage.mode == StageMode::measure, not_in_this_step);
}

Permission permit_on_workbench(const Session& session) {
  return refuse_unless(session.face == Face::workbench, only_on_workbench);
}

Permission permit_kind(const Session& session, const NextCompareMode&) {
  return permit_on_workbench(session);
}

Permission permit_kind(const Session& session, const ToggleViewOption&) {
  return permit_on_workbench(session);
}

Permission permit_kind(const Session& session, const ChangeViewOptions&) {
  return permit_on_workbench(session);
}

Permission permit_kind(const Session& session, const StartMeasuring&) {
  if (const auto refusal = permit_paper(session)) return refusal;
  return permit_on_workbench(session);
}

// To be gone to; who is there may leave it.
Permission permit_workbench(const Session& session) {
  return refuse_unless(session.has_room_for_workbench || session.face == Face::workbench, needs_larger_window);
}

Permission permit_kind(const Session& session, const ShowFace& action) {
  return action.face == Face::workbench ? permit_workbench(session) : std::nullopt;
}

Permission permit_kind(const Session& session, const SwitchFace&) {
  return permit_workbench(session);
}

// They are on the workbench.
Permission permit_kind(const Session& session, const TogglePlots&) {
  if (session.lesson && session.face == Face::stage) return plots_left_to_lesson;
  return permit_workbench(session);
}

Permission permit_view(const Session& session) {
  const StageMode mode = session.stage.mode;
  return refuse_unless(mode != StageMode::landscape && mode != StageMode::round, view_of_its_own);
}

Permission permit_kind(const Session& session, const ZoomView&) {
  return permit_view(session);
}

Permission permit_kind(const Session& session, const MoveView&) {
  return permit_view(session);
}

Permission permit_kind(const Session& session, const PanView&) {
  return permit_view(session);
}

// To take back what a measurement has set is to cancel it; then there is nothing to do again.
Permission permit_kind(const Session& session, const Redo&) {
  return refuse_unless(!is_measuring(session), measurement_sets_it);
}

Permission permit_kind(const Session& session, const SavePlots&) {
  if (!is_over_time(session.plots.tab) && is_general(session.settings)) return not_with_this_device;
  return refuse_unless(!hides_curves(session), curves_are_hidden);
}

// What was never measured cannot be believed.
Permission permit_kind(const Session& session, const Believe& action) {
  return refuse_unless(action.source != BeliefSource::measured || session.measured_k_u, not_measured);
}

Permission permit_kind(const Session& session, const BelieveMeasurement&) {
  return refuse_unless(session.measurement.stage == UserMeasurement::Stage::done, not_measured);
}

Permission permit_kind(const Session& session, const Quit& action) {
  return refuse_unless(!session.kiosk_visit || action.ends_visit, has_no_meaning);
}

}  // namespace

std::optional<Refusal> permit(const Session& session, const Action& action) {
  return std::visit(
      [&]<typename A>(const A& wanted) -> Permission {
        if (session.kiosk_visit && !is_one_of<A, ForVisitors>) return has_no_meaning;
        if (session.lesson && is_one_of<A, LeftToLesson>) return left_to_lesson;
        return permit_kind(session, wanted);
      },
      action);
}

}  // namespace ghostforce
