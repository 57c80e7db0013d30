#include "app/stage/lesson_content.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include <glm/common.hpp>

#include "app/stage/stage.h"
#include "app/stage/stage_layout.h"
#include "app/state/kiosk_visit.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/lesson_quantities.h"
#include "app/state/stage_view.h"
#include "core/scene_shape.h"

namespace ghostforce {
namespace {

LessonMark mark_of(LessonOutcome outcome) {
  if (outcome == LessonOutcome::right) return LessonMark::right;
  return outcome == LessonOutcome::wrong ? LessonMark::wrong : LessonMark::none;
}

// After an answer, what it is told; who is told nothing keeps the step's text.
std::string text_of(const LessonStepWords& words, LessonOutcome outcome, const StageLanguage::Lessons& phrases) {
  if (outcome == LessonOutcome::open) return words.text;
  const std::string& told = outcome == LessonOutcome::right ? words.right : words.wrong;
  if (told.empty()) return words.right.empty() ? words.text : words.right;
  // What follows is the right answer: without these words it would look like the wrong one.
  return outcome == LessonOutcome::wrong ? filled(phrases.not_quite, told) : told;
}

StageLessonSlider slider_content(const LessonSlider& slider, const Session& session, const StageLanguage& language) {
  const std::optional<double> value = slider_value(slider, session.settings);
  const bool is_told = value && !is_hidden(session, LessonSecret::numbers);
  return {.words = slider_words(slider, language),
          .value = is_told ? slider_text(slider, *value) : "",
          .share = value ? slider_share(slider, *value) : 0.5,
          .longest = slider_text(slider, slider.greatest)};
}

std::vector<LessonMark> answer_marks(const LessonStep& step, const LessonStepState& state, std::size_t answers) {
  std::vector<LessonMark> marks(answers, LessonMark::none);
  if (state.outcome == LessonOutcome::open) return marks;
  if (state.chosen && *state.chosen < answers) marks[*state.chosen] = LessonMark::wrong;
  if (step.right_answer < answers) marks[step.right_answer] = LessonMark::right;
  return marks;
}

std::string_view next_words(const Session& session, const StageLanguage::Lessons& phrases) {
  const LessonState& lesson = *session.lesson;
  if (has_open_question(session, LessonQuestion::guess)) return phrases.answer;
  const bool is_asked = lesson_step(lesson).question != LessonQuestion::none;
  if (is_asked && lesson_step_state(lesson).outcome == LessonOutcome::open) return phrases.show;
  // For visitors another lesson follows.
  return lesson.step + 1 == lesson.steps.size() && !session.kiosk_visit ? phrases.finish : phrases.next;
}

// As those call it who speak it. A lesson's file may have one that the stage does not speak.
std::string name_of_language(std::string_view code) {
  const StageLanguage& language = stage_language(code);
  return std::string(language.code == code ? language.name : code);
}

}  // namespace

StageLesson lesson_content(const Session& session) {
  const LessonState& lesson = *session.lesson;
  const LessonWords& words = words_in(*lesson.lesson, session.language);
  const StageLanguage& language = stage_language(session.language);
  const StageLanguage::Lessons& phrases = language.lessons;
  const LessonStep& step = lesson_step(lesson);
  const LessonStepState& state = lesson_step_state(lesson);
  StageLesson content{.title = words.title,
                      .place = filled(phrases.place, lesson.step + 1, lesson.steps.size()),
                      .text = text_of(words.steps[lesson.step], state.outcome, phrases),
                      .is_right = state.outcome == LessonOutcome::right,
                      .step = lesson.step,
                      .furthest = lesson.furthest,
                      .longest_text = {},
                      .marks = answer_marks(step, state, words.steps[lesson.step].answers.size()),
                      .chosen = state.chosen,
                      .is_open = has_open_question(session, LessonQuestion::choose),
                      .back = lesson.step > 0 ? std::string(phrases.back) : "",
                      .next = std::string(next_words(session, phrases)),
                      .has_way_out = !session.kiosk_visit,
                      .other_language = session.kiosk_visit ? name_of_language(next_language(session)) : ""};
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& each = lesson.lesson->steps[i];
    const LessonStepWords& said = words.steps[i];
    content.dots.push_back(mark_of(lesson.steps[i].outcome));
    StageLessonRow row{.answers = said.answers,
                       .has_strategies = each.controls.contains(LessonControl::strategies),
                       .has_measuring = mode_of_step(*lesson.lesson, i) == StageMode::measure};
    if (each.slider) row.slider = slider_content(*each.slider, session, language);
    content.rows.push_back(std::move(row));
    for (const LessonOutcome outcome : {LessonOutcome::open, LessonOutcome::right, LessonOutcome::wrong}) {
      std::string text = text_of(said, outcome, phrases);
      if (text.size() > content.longest_text.size()) content.longest_text = std::move(text);
    }
  }
  return content;
}

StageSecrets lesson_secrets(const Session& session) noexcept {
  return {.numbers = is_hidden(session, LessonSecret::numbers),
          .force = is_hidden(session, LessonSecret::force),
          .slide = is_hidden(session, LessonSecret::slide),
          .rest = is_hidden(session, LessonSecret::rest),
          .handle = has_open_question(session, LessonQuestion::guess)};
}

StageGuess lesson_guess(const Session& session) {
  return {.at = session.stage.guess,
          .is_open = session.stage.guess_is_open,
          .missed_by = lesson_step_state(*session.lesson).missed_by};
}

namespace {

// The way of a handle that a slow hand leads round and round.
StageRound round_at_rest(const SetUp& set_up) {
  const Settings& settings = set_up.scene.settings;
  const Circle circle = circle_inside(wall_near(settings, set_up.goal), set_up.goal, {});
  StageRound round;
  constexpr int places = 60;
  for (int i = 0; i < places; ++i) {
    const Vector<2> goal = position_on(circle, static_cast<double>(i) / places / circle.turns_per_second);
    round.loop.push_back(stage_moment_at_rest(settings, goal).handle);
  }
  return round;
}

// Things alone: words would be too small.
bool is_thing(const Mark& mark) {
  switch (mark.role) {
    case Role::button:
    case Role::hint:
    case Role::number:
    case Role::sentence:
      return false;
    default:
      return !std::holds_alternative<Label>(mark.form);
  }
}

Pane stage_pane(const SetUp& set_up, const Theme& theme, const Vector<2>& size, double scale) {
  const MeasureText no_words = [](std::string_view, const TextStyle&) { return Vector<2>(0.0); };
  const Settings& settings = set_up.scene.settings;
  constexpr int whole_explanation = 4;
  LabelMemory memory;
  Pane pane = compose_stage({.settings = settings,
                             .moment = stage_moment_at_rest(settings, set_up.goal),
                             .language = english_stage,
                             .keys = {},
                             .theme = theme,
                             .measure = no_words,
                             .shown = stage_view_of(settings, set_up.goal),
                             .reference_force = reference_force_of(settings, set_up.goal),
                             .size = size,
                             .scale = scale * height_of_design / size.y,
                             .mode = set_up.mode == StageMode::ribbon ? StageMode::none : set_up.mode,
                             .why_step = whole_explanation,
                             .round = round_at_rest(set_up),
                             .landscape_dial = settings.active == StrategyId::anisotropic ? 1.0 : 0.0,
                             .measuring = StageMeasuring{.is_running = true, .filled = 0.7}},
                            memory, 0.0)
                  .pane;
  std::erase_if(pane.marks, [](const Mark& mark) { return !is_thing(mark); });
  return pane;
}

bool shows(LessonSubject subject, Role role) {
  switch (subject) {
    case LessonSubject::everything:
      return true;
    case LessonSubject::handle:
      return role == Role::device || role == Role::proxy;
    case LessonSubject::hand:
      return role == Role::hand;
    case LessonSubject::forces:
      return role == Role::force || role == Role::wall_share || role == Role::ghost_force;
    case LessonSubject::ghost_force:
      return role == Role::ghost_force;
    case LessonSubject::slide:
      return role == Role::proxy_drift || role == Role::proxy;
    case LessonSubject::loop:
      return role == Role::area;
  }
  return false;
}

// Where its middles and ends are in the picture; empty: it is not there.
std::optional<ScreenBox> box_of(LessonSubject subject, const Pane& pane) {
  std::optional<ScreenBox> box;
  const auto add = [&](const Vector<2>& world) {
    const Vector<2> at = to_screen(pane.camera, world);
    if (!box) box = ScreenBox{at, at};
    box->include(at);
  };
  for (const Mark& mark : pane.marks) {
    if (!shows(subject, mark.role)) continue;
    if (const auto* const line = std::get_if<Line>(&mark.form)) add(line->from), add(line->to);
    if (const auto* const arrow = std::get_if<Arrow>(&mark.form)) add(arrow->tail), add(arrow->tip);
    if (const auto* const marker = std::get_if<Marker>(&mark.form)) add(marker->center);
  }
  return box;
}

}  // namespace

Pane lesson_card(std::size_t number, const Theme& theme, const Vector<2>& size, double scale) {
  const SetUp nothing;
  const Lesson& lesson = *shipped_lessons()[number];
  const LessonStep& step = lesson.steps[lesson.picture];
  const SetUp* const set_up = step.reveal ? step.reveal.get() : step.set_up.get();
  const SetUp& shown = set_up == nullptr ? nothing : *set_up;
  Pane whole = stage_pane(shown, theme, size, scale);
  if (lesson.picture_of == LessonSubject::everything) return whole;
  const std::optional<ScreenBox> subject = box_of(lesson.picture_of, whole);
  if (!subject) return whole;
  // So large that it takes half of the picture, with all that is drawn.
  constexpr double taken = 0.5;
  constexpr double largest = 3.0;
  const Vector<2> room = taken * size / glm::max(subject->extent(), Vector<2>(1.0));
  const double closer = std::clamp(std::min(room.x, room.y), 1.0, largest);
  Pane part = stage_pane(shown, theme, closer * size, closer * scale);
  const ScreenBox there = box_of(lesson.picture_of, part).value_or(*subject);
  part.camera.center = to_world(part.camera, 0.5 * (there.least + there.most));
  part.camera.size = size;
  return part;
}

}  // namespace ghostforce
