#include "app/stage/lesson_content.h"

#include <utility>

#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/lesson_slider.h"
#include "app/state/kiosk_visit.h"

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

}  // namespace ghostforce
