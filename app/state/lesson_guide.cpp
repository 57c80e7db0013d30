#include "app/state/lesson_guide.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/state/lesson_file.h"
#include "app/state/mode_changes.h"
#include "app/state/stage_view.h"
#include "app/state/stiffness_probe_guide.h"
#include "app/state/user_measurement_guide.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

constexpr double glide_lasts_s = 1.0;
// Longer than the stage takes to switch strategies: what is met can also be seen.
constexpr double task_lasts_s = 0.8;

LessonStepState& present_state(LessonState& lesson) {
  return lesson.steps[lesson.step];
}

bool is_open(const LessonState& lesson) {
  const bool is_asked = lesson_step(lesson).question != LessonQuestion::none;
  return is_asked && lesson_step_state(lesson).outcome == LessonOutcome::open;
}

bool is_why(const SetUp* set_up) {
  return set_up != nullptr && set_up->mode == StageMode::why;
}

// Steps of Why? that follow one another add one force after another, and the last one shows all of them.
int why_step_at(const Lesson& lesson, std::size_t step) {
  int after = 0;
  for (std::size_t i = step + 1; i < lesson.steps.size(); ++i) {
    const SetUp* const set_up = lesson.steps[i].set_up.get();
    if (set_up != nullptr && !is_why(set_up)) break;
    if (is_why(set_up)) ++after;
  }
  return std::max(1, last_why_step - after);
}

void show_mode(Session& session, const SetUp& set_up) {
  if (session.stage.mode != set_up.mode) {
    leave_stage_mode(session);
    if (set_up.mode != StageMode::none) begin_stage_mode(session, set_up.mode);
  }
  if (is_why(&set_up)) session.stage.why_step = why_step_at(*session.lesson->lesson, session.lesson->step);
}

void state(Session& session, const SetUp& set_up) {
  LessonState& lesson = *session.lesson;
  session.settings = set_up.scene.settings;
  session.stage.switches_slowly = false;
  show_mode(session, set_up);
  const Vector<2> goal = nearest_in_scene(set_up.goal);
  lesson.glide.reset();
  if (goal != session.goal) lesson.glide = LessonState::Glide{session.goal, goal, session.goal, 0.0};
  session.fits_view = true;
}

// What was stated last on the way to this step, and at it once its question is answered; null: nothing.
const SetUp* stated_set_up(const LessonState& lesson) {
  const std::vector<LessonStep>& steps = lesson.lesson->steps;
  const SetUp* found = nullptr;
  for (std::size_t i = 0; i <= lesson.step; ++i) {
    if (steps[i].set_up) found = steps[i].set_up.get();
    const bool is_revealed = i < lesson.step || lesson.steps[i].outcome != LessonOutcome::open;
    if (steps[i].reveal && is_revealed) found = steps[i].reveal.get();
  }
  return found;
}

Vector<2> hand_of(const Session& session) {
  return session.lesson->glide ? session.lesson->glide->to : session.goal;
}

// What was done before stays done.
void note_progress(Session& session) {
  const LessonState& lesson = *session.lesson;
  LessonRecord& record = session.lesson_progress.lessons[progress_key(*lesson.lesson)];
  record.farthest = std::max(record.farthest, lesson.furthest);
  record.is_finished = record.is_finished || lesson.is_finished;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    if (lesson.steps[i].outcome == LessonOutcome::right) record.right.insert(lesson.lesson->steps[i].name);
  }
}

void begin_step(Session& session) {
  LessonState& lesson = *session.lesson;
  lesson.furthest = std::max(lesson.furthest, lesson.step);
  note_progress(session);
  lesson.met_s = 0.0;
  end_stiffness_probe(session);
  session.stage.is_black = false;
  session.stage.guess.reset();
  session.stage.guess_is_open = false;
  if (lesson_step(lesson).question != LessonQuestion::guess) return;
  const LessonStepState& state = lesson_step_state(lesson);
  session.stage.guess_is_open = state.outcome == LessonOutcome::open;
  session.stage.guess =
      session.stage.guess_is_open ? std::optional(neutral_guess(settings_now(session), hand_of(session))) : state.guess;
}

void show_again(Session& session) {
  if (const SetUp* const set_up = stated_set_up(*session.lesson)) state(session, *set_up);
  begin_step(session);
}

// A hand that moves by itself does not wait for an answer.
void take_hand(Session& session) {
  const std::string input = session.wanted_input.value_or(session.input);
  const auto& moving = hands_moving_by_themselves;
  if (std::ranges::find(moving, input, &InputChoice::name) != moving.end()) session.wanted_input = mouse_hand.name;
}

void close_question(Session& session, LessonOutcome outcome) {
  LessonState& lesson = *session.lesson;
  present_state(lesson).outcome = outcome;
  note_progress(session);
  session.stage.guess_is_open = false;
  if (const auto& reveal = lesson_step(lesson).reveal) state(session, *reveal);
}

void end_glide(Session& session) {
  session.goal = hand_of(session);
  session.lesson->glide.reset();
}

void glide_on(Session& session, double interval_s) {
  std::optional<LessonState::Glide>& glide = session.lesson->glide;
  if (!glide) return;
  if (session.drags_goal || session.goal != glide->last) return glide.reset();
  glide->elapsed_s += reduces_motion(session) ? glide_lasts_s : interval_s;
  const double share = glide->elapsed_s < glide_lasts_s ? minimum_jerk(glide->elapsed_s / glide_lasts_s) : 1.0;
  session.goal = glide->last = share < 1.0 ? glm::mix(glide->from, glide->to, share) : glide->to;
  if (share == 1.0) glide.reset();
}

}  // namespace

const LessonStep& lesson_step(const LessonState& lesson) noexcept {
  return lesson.lesson->steps[lesson.step];
}

const LessonStepState& lesson_step_state(const LessonState& lesson) noexcept {
  return lesson.steps[lesson.step];
}

void begin_lesson(Session& session, std::shared_ptr<const Lesson> lesson) {
  if (is_measuring(session)) cancel_measurement(session);
  const LessonState::Before before = session.lesson
                                         ? session.lesson->before
                                         : LessonState::Before{session.settings, session.goal,  session.stage_shown,
                                                               session.face,     session.speed, session.belief_source};
  leave_stage_mode(session);
  take_hand(session);
  LessonState state{.lesson = std::move(lesson), .steps = {}, .before = before};
  state.steps.resize(state.lesson->steps.size());
  session.lesson = std::move(state);
  session.belief_source = BeliefSource::typed;
  session.face = Face::stage;
  session.dialog = Dialog::none;
  session.paused = false;
  session.speed = 1.0;
  session.stage.looks_back_to_s.reset();
  session.stage.demo_step.reset();
  show_again(session);
}

void abandon_lesson(Session& session) {
  if (!session.lesson) return;
  leave_stage_mode(session);
  session.speed = session.lesson->before.speed;
  session.face = session.lesson->before.face;
  session.lesson.reset();
}

void leave_lesson(Session& session) {
  if (!session.lesson) return;
  const LessonState::Before before = session.lesson->before;
  abandon_lesson(session);
  session.settings = before.settings;
  session.belief_source = before.belief_source;
  session.stage_shown = before.stage_shown;
  if (session.goal == before.goal) return;
  session.goal = before.goal;
  ++session.restarts_asked;  // at rest there, not on a way that nobody went
}

void next_lesson_step(Session& session) {
  LessonState& lesson = *session.lesson;
  if (is_open(lesson)) return show_answer_in_lesson(session);
  if (lesson.step + 1 == lesson.steps.size()) {
    lesson.is_finished = true;
    note_progress(session);
    session.lesson_gone_through = progress_key(*lesson.lesson);
    leave_lesson(session);
    if (session.kiosk_visit) return begin_lesson(session, session.kiosk_visit->take_next_lesson());
    session.dialog = Dialog::lessons;
    return;
  }
  ++lesson.step;
  const bool is_stated = lesson_step(lesson).set_up || lesson_step_state(lesson).outcome != LessonOutcome::open;
  is_stated ? show_again(session) : begin_step(session);
}

void previous_lesson_step(Session& session) {
  if (session.lesson->step == 0) return;
  --session.lesson->step;
  show_again(session);
}

void show_lesson_step(Session& session, std::size_t step) {
  LessonState& lesson = *session.lesson;
  lesson.step = std::min(step, lesson.steps.size() - 1);
  show_again(session);
  end_glide(session);
}

void begin_lesson_step_anew(Session& session) {
  show_lesson_step(session, session.lesson->step);
  ++session.restarts_asked;
  session.fits_view = true;
}

void settle_in_lesson(Session& session, std::size_t answer) {
  answer_in_lesson(session, answer);
  if (has_open_question(session, LessonQuestion::guess)) {
    const double off = answer == 0 ? 0.5 : 3.0;
    const Vector<2> rest = stage_moment_at_rest(settings_now(session), session.goal).handle;
    session.stage.guess = rest + Vector<2>(0.0, off * lesson_step(*session.lesson).within);
    guess_in_lesson(session);
  } else if (has_open_question(session, LessonQuestion::task)) {
    answer == 0 ? close_question(session, LessonOutcome::right) : show_answer_in_lesson(session);
  }
  end_glide(session);
}

void confirm_in_lesson(Session& session) {
  has_open_question(session, LessonQuestion::guess) ? guess_in_lesson(session) : next_lesson_step(session);
}

void answer_in_lesson(Session& session, std::size_t answer) {
  if (!has_open_question(session, LessonQuestion::choose)) return;
  LessonState& lesson = *session.lesson;
  if (answer >= words_in(*lesson.lesson, session.language).steps[lesson.step].answers.size()) return;
  present_state(lesson).chosen = answer;
  const bool is_right = answer == lesson_step(lesson).right_answer;
  close_question(session, is_right ? LessonOutcome::right : LessonOutcome::wrong);
}

void guess_in_lesson(Session& session) {
  if (!has_open_question(session, LessonQuestion::guess) || !session.stage.guess) return;
  LessonState& lesson = *session.lesson;
  LessonStepState& state = present_state(lesson);
  state.guess = session.stage.guess;
  state.missed_by = glm::distance(*state.guess, stage_moment_at_rest(settings_now(session), hand_of(session)).handle);
  const bool is_right = *state.missed_by <= lesson_step(lesson).within;
  close_question(session, is_right ? LessonOutcome::right : LessonOutcome::wrong);
}

void show_answer_in_lesson(Session& session) {
  if (!is_open(*session.lesson)) return;
  // A ring that nobody has placed says nothing.
  session.stage.guess.reset();
  close_question(session, LessonOutcome::shown);
}

void move_lesson_slider(Session& session, double value) {
  if (!session.lesson || !lesson_step(*session.lesson).slider || std::isnan(value)) return;
  session.settings = with_slider_value(*lesson_step(*session.lesson).slider, session.settings, value);
}

void nudge_lesson_slider(Session& session, double hundredths) {
  if (!session.lesson || !lesson_step(*session.lesson).slider) return;
  const LessonSlider& slider = *lesson_step(*session.lesson).slider;
  const std::optional<double> value = slider_value(slider, session.settings);
  const double share = value ? slider_share(slider, *value) : 0.5;
  move_lesson_slider(session, slider_value_at(slider, share + 0.01 * hundredths));
}

void follow_lesson(Session& session, const LessonReading& reading, double interval_s) {
  if (!session.lesson) return;
  if (session.lesson->glide) return glide_on(session, interval_s);
  if (!has_open_question(session, LessonQuestion::task)) return;
  LessonState& lesson = *session.lesson;
  // What is being turned or slid may only be on its way; a hand that presses is held for as long as it presses.
  const bool is_turning = session.is_editing && !session.drags_goal;
  lesson.met_s = !is_turning && is_done(lesson_step(lesson), reading) ? lesson.met_s + interval_s : 0.0;
  if (lesson.met_s >= task_lasts_s) close_question(session, LessonOutcome::right);
}

bool is_allowed(const Session& session, LessonControl control) noexcept {
  return !session.lesson || lesson_step(*session.lesson).controls.contains(control);
}

bool is_hidden(const Session& session, LessonSecret secret) noexcept {
  if (!session.lesson) return false;
  if (session.lesson->lesson->secrets.contains(secret)) return true;
  if (!is_open(*session.lesson)) return false;
  return lesson_step(*session.lesson).secrets.contains(secret);
}

bool has_open_question(const Session& session, LessonQuestion question) noexcept {
  return session.lesson && lesson_step(*session.lesson).question == question && is_open(*session.lesson);
}

std::size_t lesson_to_go_on_with(const Session& session) {
  const auto& lessons = shipped_lessons();
  const auto& records = session.lesson_progress.lessons;
  const auto is_last = [&](const auto& lesson) { return progress_key(*lesson) == session.lesson_gone_through; };
  const auto last = std::ranges::find_if(lessons, is_last);
  const std::size_t first = last == lessons.end() ? 0 : static_cast<std::size_t>(last - lessons.begin()) + 1;
  for (std::size_t i = 0; i < lessons.size(); ++i) {
    const std::size_t number = (first + i) % lessons.size();
    const auto found = records.find(progress_key(*lessons[number]));
    if (found == records.end() || !found->second.is_finished) return number;
  }
  return first % lessons.size();
}

StageMode mode_of_step(const Lesson& lesson, std::size_t step) noexcept {
  StageMode mode = StageMode::none;
  for (std::size_t i = 0; i <= step; ++i) {
    if (i > 0 && lesson.steps[i - 1].reveal) mode = lesson.steps[i - 1].reveal->mode;
    if (lesson.steps[i].set_up) mode = lesson.steps[i].set_up->mode;
  }
  return mode;
}

SceneView stage_view_of(const Session& session) {
  if (session.stage.mode == StageMode::landscape && has_joints(session.settings))
    return workspace_view(session.settings);
  const double reference_force = reference_force_of(session);
  if (!session.lesson) {
    return stage_view_of(session.settings, std::span(&session.goal, 1), reference_force, session.stage.guess);
  }
  const LessonState& lesson = *session.lesson;
  std::vector<Vector<2>> goals{hand_of(session)};
  for (const auto* const each : {&lesson_step(lesson).set_up, &lesson_step(lesson).reveal}) {
    if (!*each) continue;
    const Settings& settings = (*each)->scene.settings;
    const bool is_same_wall = settings.wall_point == session.settings.wall_point &&
                              settings.wall_normal_angle == session.settings.wall_normal_angle;
    if (is_same_wall) goals.push_back((*each)->goal);
  }
  return stage_view_of(session.settings, goals, reference_force);
}

double reference_force_of(const Session& session) {
  if (!session.lesson) return reference_force_of(session.scene->settings, session.scene->goal.points.back());
  double greatest = 0.1;  // [N], so that nothing is divided by
  for (const LessonStep& step : session.lesson->lesson->steps) {
    for (const auto* const set_up : {&step.set_up, &step.reveal}) {
      if (*set_up) greatest = std::max(greatest, reference_force_of((*set_up)->scene.settings, (*set_up)->goal));
    }
  }
  return greatest;
}

}  // namespace ghostforce
