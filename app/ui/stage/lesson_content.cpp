#include "app/ui/stage/lesson_content.h"

#include <utility>

#include "app/lessons/lesson_file.h"
#include "app/lessons/lesson_phrases.h"
#include "app/lessons/lesson_slider.h"
#include "app/session/lesson_guide.h"
#include "app/session/visit.h"

namespace ghostforce {
namespace {

LessonMark mark_of(LessonOutcome outcome) {
  if (outcome == LessonOutcome::right) return LessonMark::right;
  return outcome == LessonOutcome::wrong ? LessonMark::wrong : LessonMark::none;
}

// After an answer, what it is told; who is told nothing keeps the step's text.
const std::string& text_of(const LessonStepWords& words, LessonOutcome outcome) {
  if (outcome == LessonOutcome::open) return words.text;
  const std::string& told = outcome == LessonOutcome::right ? words.right : words.wrong;
  if (!told.empty()) return told;
  return words.right.empty() ? words.text : words.right;
}

StageLessonSlider slider_content(const LessonSlider& slider, const Session& session, std::string_view language) {
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

std::string_view next_words(const Session& session, const LessonPhrases& phrases) {
  const LessonState& lesson = *session.lesson;
  if (has_open_question(session, LessonQuestion::guess)) return phrases.answer;
  const bool is_asked = lesson_step(lesson).question != LessonQuestion::none;
  if (is_asked && lesson_step_state(lesson).outcome == LessonOutcome::open) return phrases.show;
  // For visitors another lesson follows.
  return lesson.step + 1 == lesson.steps.size() && !session.visit ? phrases.finish : phrases.next;
}

// As those call it who speak it.
std::string name_of_language(std::string_view language) {
  const LessonPhrases& phrases = lesson_phrases(language);
  return std::string(phrases.language == language ? phrases.own_name : language);
}

}  // namespace

StageLesson lesson_content(const Session& session) {
  const LessonState& lesson = *session.lesson;
  const LessonWords& words = words_in(*lesson.lesson, lesson.language);
  const LessonPhrases& phrases = lesson_phrases(lesson.language);
  const LessonStep& step = lesson_step(lesson);
  const LessonStepState& state = lesson_step_state(lesson);
  std::string place = std::to_string(lesson.step + 1);
  place.append(" ").append(phrases.of).append(" ").append(std::to_string(lesson.steps.size()));
  StageLesson content{.title = words.title,
                      .place = std::move(place),
                      .text = text_of(words.steps[lesson.step], state.outcome),
                      .mark = mark_of(state.outcome),
                      .step = lesson.step,
                      .furthest = lesson.furthest,
                      .longest_text = {},
                      .marks = answer_marks(step, state, words.steps[lesson.step].answers.size()),
                      .chosen = state.chosen,
                      .is_open = has_open_question(session, LessonQuestion::choose),
                      .back = lesson.step > 0 ? std::string(phrases.back) : "",
                      .next = std::string(next_words(session, phrases)),
                      .leave_words = session.visit ? "" : std::string(phrases.leave),
                      .other_language = session.visit ? name_of_language(next_language(lesson)) : ""};
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const LessonStep& each = lesson.lesson->steps[i];
    const LessonStepWords& said = words.steps[i];
    content.dots.push_back(mark_of(lesson.steps[i].outcome));
    StageLessonRow row{.answers = said.answers, .has_strategies = each.controls.contains(LessonControl::strategies)};
    if (each.slider) row.slider = slider_content(*each.slider, session, lesson.language);
    content.rows.push_back(std::move(row));
    for (const std::string* const text : {&said.text, &said.right, &said.wrong}) {
      if (text->size() > content.longest_text.size()) content.longest_text = *text;
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
