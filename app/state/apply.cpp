#include "app/state/apply.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/state/kiosk_visit.h"
#include "app/state/lesson_guide.h"
#include "app/state/mode_changes.h"
#include "app/state/permit.h"
#include "app/state/scene_view.h"
#include "app/state/stiffness_probe_guide.h"
#include "app/state/talk.h"
#include "app/state/user_measurement_guide.h"
#include "core/conventions.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

// --- Hand, motor and wall ---

// Another goal would be another question, so a guess that is open is what moves.
void act(Session& session, const MoveHandBy& action) {
  if (session.stage.guess && session.stage.guess_is_open) {
    session.stage.guess = nearest_in_scene(*session.stage.guess + action.by);
  } else if (is_allowed(session, LessonControl::hand)) {
    session.goal = nearest_in_scene(session.goal + action.by);
  } else {
    constexpr double metres_per_hundredth = 0.001;
    nudge_lesson_slider(session, (action.by.x + action.by.y) / metres_per_hundredth);
  }
}

void act(Session& session, const MoveHandTo& action) {
  session.goal = nearest_in_scene(action.goal);
  session.drags_goal = true;
}

void act(Session& session, const LetGoOfHand&) {
  session.drags_goal = false;
}

void act(Session& session, const MoveGuessTo& action) {
  session.stage.guess = nearest_in_scene(action.guess);
}

void act(Session& session, const TurnMotorTo& action) {
  session.settings.actuated_angle = action.angle;
}

void act(Session& session, const TurnWallTo& action) {
  session.settings.wall_normal_angle = action.angle;
}

void act(Session& session, const GoToLandscapePoint& action) {
  session.settings = with_landscape_point(session.settings, action.point);
}

void act(Session& session, const TurnMotorBy& action) {
  double& angle = session.settings.actuated_angle;
  const double step = std::abs(action.degrees) * radians_per_degree;
  angle = std::remainder((std::round(angle / step) + (action.degrees > 0 ? 1.0 : -1.0)) * step, 2.0 * std::numbers::pi);
}

// The normal's angle at which the naïve proxy drifts farthest for a goal at a given depth, tan θ = √(1 + k_r/k_u) with
// θ between normal and motor axis; of the four such angles the nearest to the present one [rad].
double angle_of_largest_drift(const Settings& settings) noexcept {
  const double theta = std::atan(std::sqrt(1.0 + settings.stiffnesses.k_r / settings.stiffnesses.k_u));
  double nearest = settings.wall_normal_angle;
  double least_turn = 4.0;  // more than any
  for (const double offset : {theta, -theta, std::numbers::pi + theta, std::numbers::pi - theta}) {
    const double angle = std::remainder(settings.actuated_angle + offset, 2.0 * std::numbers::pi);
    const double turn = std::abs(std::remainder(angle - settings.wall_normal_angle, 2.0 * std::numbers::pi));
    if (turn < least_turn) {
      least_turn = turn;
      nearest = angle;
    }
  }
  return nearest;
}

void act(Session& session, const TurnWallToLargestDrift&) {
  session.settings.wall_normal_angle = angle_of_largest_drift(session.settings);
}

void act(Session& session, const MovePart& action) {
  session.settings = with_part_at(session.settings, action.part, action.to, session.goal);
}

void act(Session& session, const SwitchMotor&) {
  if (session.motor_line_turns) {
    session.device_motor = 1 - session.device_motor;
  } else {
    session.settings = with_other_motor(session.settings);
  }
}

void act(Session& session, const UseMotors& action) {
  if (action.motors == MotorsInUse::both) return choose_strategy(session, StrategyId::full, false);
  session.device_motor = action.motors == MotorsInUse::first ? 0 : 1;
  if (session.settings.active == StrategyId::full) choose_strategy(session, StrategyId::naive, false);
}

void act(Session& session, const TurnRatio& action) {
  turn_ratio(session, action.factor);
}

// --- Strategies ---

void act(Session& session, const ChooseStrategy& action) {
  choose_strategy(session, action.id, action.slowly);
}

void act(Session& session, const ChooseByNumber& action) {
  if (has_open_question(session, LessonQuestion::choose)) return answer_in_lesson(session, index_of(action.id));
  act(session, ChooseStrategy{action.id});
}

// The lit button is the nearer end's.
void act(Session& session, const TurnLandscapeDial& action) {
  session.stage.landscape_dial = action.cure;
  session.settings.active = strategy_of_dial(action.cure);
}

// --- Time ---

void act(Session& session, const LookBackTo& action) {
  session.stage.looks_back_to_s = action.time_s;
}

void go_on_live(Session& session) {
  session.stage.looks_back_to_s.reset();
  session.paused = false;
}

void act(Session& session, const TogglePause&) {
  if (session.stage.looks_back_to_s) return go_on_live(session);
  session.paused = !session.paused;
}

void act(Session& session, const StepBack&) {
  session.paused = true;
  --session.ticks_through_history;
}

void act(Session& session, const StepOn&) {
  session.paused = true;
  const bool looks_back = session.stage.looks_back_to_s || session.ticks_through_history < 0;
  if (looks_back) {
    ++session.ticks_through_history;
  } else {
    ++session.steps_asked;
  }
}

void act(Session& session, const Restart& action) {
  if (session.lesson) return begin_lesson_step_anew(session);
  if (action.with_scene_settings) {
    if (is_measuring(session)) cancel_measurement(session);
    session.settings = session.scene->settings;
  }
  session.goal = session.scene->goal.points.back();
  ++session.restarts_asked;
  if (session.face == Face::stage) session.fits_view = true;  // the view may have followed the hand elsewhere
}

// --- Stage ---

void act(Session& session, const ShowFace& action) {
  if (action.face == Face::workbench) leave_stage(session);
  session.face = action.face;
}

void act(Session& session, const SwitchFace&) {
  act(session, ShowFace{session.face == Face::stage ? Face::workbench : Face::stage});
}

void act(Session& session, const ToggleMode& action) {
  session.face = Face::stage;
  session.stage.is_black = false;
  if (session.stage.mode == action.mode) return leave_stage_mode(session);
  begin_stage_mode(session, action.mode);
  // A lesson waits until its button is pressed.
  if (action.mode == StageMode::measure) start_stiffness_probe(session);
}

void act(Session& session, const PressMeasuringButton&) {
  press_stiffness_probe(session);
}

void act(Session& session, const MeasureHand&) {
  session.lesson ? press_stiffness_probe(session) : act(session, ToggleMode{StageMode::measure});
}

// A word about what was before is none about what comes.
void dismiss_news(Session& session) {
  if (session.notice && !session.notice->is_problem) session.notice.reset();
}

void act(Session& session, const GoOn&) {
  dismiss_news(session);
  if (session.lesson) return confirm_in_lesson(session);
  StageChoice& stage = session.stage;
  const bool is_in_wall = depth_in_wall(session.settings, session.goal) > 0.0;
  if (stage.mode == StageMode::predict && is_in_wall) ++stage.reveals_asked;
  if (stage.mode == StageMode::measure) press_stiffness_probe(session);
  if (stage.mode == StageMode::why) stage.why_step = std::min(stage.why_step + 1, last_why_step);
}

void act(Session& session, const Confirm&) {
  const bool takes_reading = is_measuring(session) && session.dialog == Dialog::none;
  takes_reading ? take_reading(session) : act(session, GoOn{});
}

void act(Session& session, const ToggleNumbers&) {
  session.stage.hides_numbers = !session.stage.hides_numbers;
  session.notice.reset();
  if (!session.stage.hides_numbers) return;
  session.notice = Notice{std::string(stage_language(session.language).notices.numbers_hidden)};
}

void act(Session& session, const ToggleMenu&) {
  session.stage.shows_menu = !session.stage.shows_menu;
}

void act(Session& session, const ToggleBlank&) {
  session.stage.is_black = !session.stage.is_black;
}

// --- The talk ---

void act(Session& session, const NextStep&) {
  dismiss_news(session);
  if (session.lesson) return next_lesson_step(session);
  // Who has come to Why? by its key goes on there.
  const bool is_in_why = session.stage.mode == StageMode::why && session.stage.why_step < last_why_step;
  if (is_in_why && !session.stage.demo_step) return act(session, GoOn{});
  go_to_talk_step(session, session.stage.demo_step.value_or(-1) + 1);
}

void act(Session& session, const PreviousStep&) {
  dismiss_news(session);
  if (session.lesson) return previous_lesson_step(session);
  go_to_talk_step(session, session.stage.demo_step.value_or(0) - 1);
}

// --- Lessons and motors ---

void act(Session& session, const AnswerLesson& action) {
  answer_in_lesson(session, action.answer);
}

void act(Session& session, const MoveSliderTo& action) {
  move_lesson_slider(session, action.value);
}

void act(Session& session, const NudgeSlider& action) {
  nudge_lesson_slider(session, action.hundredths);
}

void act(Session& session, const LeaveLesson&) {
  leave_lesson(session);
}

void act(Session& session, const NextLanguage&) {
  switch_to_next_language(session);
}

void act(Session& session, const ArmMotors&) {
  ++session.arms_asked;
}

void act(Session& session, const ConfirmZeroPose&) {
  ++session.zero_poses_confirmed;
}

void act(Session& session, const StopMotors&) {
  ++session.offs_asked;
  if (!session.has_motors) session.notice = Notice{std::string(stage_language(session.language).refusals.no_motors)};
}

void act(Session& session, const AcknowledgeOff&) {
  ++session.acknowledgements;
}

// It never quits.
void act(Session& session, const Escape&) {
  ++session.offs_asked;
  // Whoever stops the motors goes on seeing why that was needed; a second one closes what is open.
  if (session.motors_may_push) return;
  const bool was_black = std::exchange(session.stage.is_black, false);
  const bool was_menu = std::exchange(session.stage.shows_menu, false);
  // News go by themselves, and need no Esc of their own.
  const bool was_problem = session.notice && session.notice->is_problem;
  const bool closes_more = was_black || was_menu || session.dialog != Dialog::none || was_problem;
  session.dialog = Dialog::none;
  session.notice.reset();
  if (closes_more) return;
  if (session.lesson) {
    if (!permit(session, LeaveLesson{})) leave_lesson(session);
  } else if (session.stage.looks_back_to_s || session.stage.mode != StageMode::none) {
    if (session.stage.looks_back_to_s) go_on_live(session);
    if (session.stage.mode != StageMode::none) leave_stage_mode(session);
  } else {
    session.hint.reset();
  }
}

// --- View and window ---

void act(Session& session, const NextCompareMode&) {
  const std::size_t next = static_cast<std::size_t>(session.options.compare) + 1;
  session.options.compare = compare_catalog()[next % compare_catalog().size()].id;
}

void act(Session& session, const ToggleViewOption& action) {
  session.options.*action.option = !(session.options.*action.option);
}

void act(Session& session, const FitView&) {
  session.fits_view = true;
}

SceneView& view_of_face(Session& session) {
  return session.face == Face::stage ? session.stage_shown : session.shown;
}

// Side by side each pane has a place of its own.
bool has_panes(const Session& session) {
  return session.face == Face::workbench && session.pane_views;
}

void act(Session& session, const ZoomView& action) {
  if (has_panes(session)) {
    const StrategyId active = session.settings.active;
    const ZoomView::Place middle{session.pane_views->centers[index_of(active)], active};
    const ZoomView::Place place = action.place.value_or(middle);
    session.pane_views = zoomed(*session.pane_views, action.factor, place.pane, place.at);
  } else {
    SceneView& view = view_of_face(session);
    view = zoomed(view, action.factor, action.place ? action.place->at : view.center);
  }
}

void act(Session& session, const MoveView& action) {
  if (has_panes(session)) {
    session.pane_views = moved(*session.pane_views, action.by);
  } else {
    SceneView& view = view_of_face(session);
    view = within_scene_limits({view.center + action.by, view.width});
  }
}

void act(Session& session, const PanView& action) {
  const double width = has_panes(session) ? session.pane_views->width : view_of_face(session).width;
  act(session, MoveView{width * action.shares});
}

// The stage has none, so they are opened where they are.
void act(Session& session, const TogglePlots&) {
  const bool is_on_stage = session.face == Face::stage;
  if (is_on_stage) act(session, ShowFace{Face::workbench});
  session.plots.is_open = is_on_stage || !session.plots.is_open;
}

void act(Session& session, const NextTheme&) {
  const auto themes = theme_catalog();
  const std::size_t next = static_cast<std::size_t>(session.appearance.theme - themes.data()) + 1;
  session.appearance.theme = &themes[next % themes.size()];
}

void act(Session& session, const ChangeTextSize& action) {
  constexpr double step = 0.05;
  const double nearest = std::round(session.appearance.scale / step);
  session.appearance.scale =
      std::clamp((nearest + action.steps) * step, Appearance::least_scale, Appearance::greatest_scale);
}

void act(Session& session, const UseUsualTextSize&) {
  session.appearance.scale = 1.0;
}

void act(Session& session, const OpenDialog& action) {
  session.dialog = action.dialog;
}

void act(Session& session, const ToggleDialog& action) {
  session.dialog = session.dialog == action.dialog ? Dialog::none : action.dialog;
}

void act(Session& session, const ChooseInput& action) {
  session.wanted_input = action.name;
}

// --- Controls ---

template <auto Session::*member>
void act(Session& session, const Change<member>& action) {
  session.*member = action.after;
}

void act(Session& session, const HoldControl& action) {
  session.is_editing = action.is_held;
}

void act(Session& session, const ChangeStiffnesses& action) {
  session.settings.stiffnesses = action.after;
}

void act(Session& session, const Believe& action) {
  if (action.source == BeliefSource::measured) return believe_measured(session, *session.measured_k_u);
  session.belief_source = action.source;
  if (action.source == BeliefSource::typed) session.settings.stiffnesses.believed_k_u = action.k_u;
}

void act(Session& session, const StartMeasuring&) {
  start_measuring(session);
}

void act(Session& session, const TakeReading&) {
  take_reading(session);
}

void act(Session& session, const CancelMeasuring&) {
  cancel_measurement(session);
}

void act(Session& session, const RevealHand&) {
  reveal_hand(session);
}

void act(Session& session, const BelieveMeasurement&) {
  believe_measurement(session);
}

void act(Session& session, const BeginCircleTest&) {
  begin_circle_test(session);
}

void act(Session& session, const EndCircleTest&) {
  end_circle_test(session);
}

void act(Session& session, const ChangeCircle& action) {
  session.circle_test.choice = action.after;
}

void act(Session& session, const FollowNewest&) {
  session.plots.follows = true;
  session.stage.looks_back_to_s.reset();
}

void act(Session& session, const ForgetLessons&) {
  session.lesson_progress = {};
}

void act(Session& session, const CloseDialog&) {
  session.dialog = Dialog::none;
}

void act(Session& session, const CloseNotice&) {
  session.notice.reset();
}

void act(Session& session, const HideHints&) {
  session.hint.reset();
}

}  // namespace

bool escape_has_use(const Session& session) {
  const StageChoice& stage = session.stage;
  return session.motors_may_push || stage.is_black || stage.shows_menu || session.dialog != Dialog::none ||
         (session.notice && session.notice->is_problem) || stage.looks_back_to_s || stage.mode != StageMode::none ||
         session.hint || (session.lesson && !permit(session, LeaveLesson{}));
}

Effects apply(Session& session, const Action& action) {
  if (const std::optional<Refusal> refusal = permit(session, action)) {
    const std::string_view words = stage_language(session.language).refusals.*refusal->words;
    if (refusal->is_told) session.notice = Notice{std::string(words), refusal->is_problem, 0.0};
    return {};
  }
  Effects effects;
  std::visit(
      [&]<typename A>(const A& wanted) {
        if constexpr (!is_one_of<A, LeavesMenuOpen>) session.stage.shows_menu = false;
        if constexpr (is_one_of<A, Effect>) {
          effects.emplace_back(wanted);
        } else {
          act(session, wanted);
        }
      },
      action);
  return effects;
}

}  // namespace ghostforce
