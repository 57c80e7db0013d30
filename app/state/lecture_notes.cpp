#include "app/state/lecture_notes.h"

#include <cstddef>

#include <fmt/format.h>

#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/stage_language.h"

namespace ghostforce {
namespace {

std::string titled(const StageLanguage& language, std::size_t step, std::size_t steps, std::string_view title) {
  return fmt::format("{} · {}", filled(language.lessons.place, step + 1, steps), title);
}

// Before its first step all of it comes next.
LectureNotes talk_notes(const Session& session, const StageLanguage& language) {
  const StageLanguage::Lecture& all = language.lecture;
  const std::optional<int> step = session.stage.demo_step;
  LectureNotes notes{.title = std::string(all.talk), .words = std::string(all.begins), .next = std::string(all.last)};
  const std::size_t next = step ? static_cast<std::size_t>(*step) + 1 : 0;
  if (step) {
    const StageLanguage::Lecture::Step& present = all.steps[next - 1];
    notes.title = titled(language, next - 1, all.steps.size(), present.title);
    notes.words = present.notes;
  }
  if (next < all.steps.size()) notes.next = filled(all.next, all.steps[next].title);
  return notes;
}

// The answer to what is asked, before the room has given it, and what there is to say of it.
LectureNotes lesson_notes(const LessonState& state, const StageLanguage& language) {
  const StageLanguage::Lecture& all = language.lecture;
  const LessonWords& words = words_in(*state.lesson, language.code);
  const LessonStep& step = state.lesson->steps[state.step];
  const LessonStepWords& said = words.steps[state.step];
  LectureNotes notes{.title = titled(language, state.step, words.steps.size(), words.title),
                     .words = said.right,
                     .next = std::string(all.last)};
  if (step.question == LessonQuestion::choose) {
    notes.words =
        fmt::format("{} {}", filled(all.answer, step.right_answer + 1, said.answers[step.right_answer]), said.right);
  }
  if (state.step + 1 < words.steps.size()) notes.next = filled(all.next, words.steps[state.step + 1].text);
  return notes;
}

}  // namespace

LectureNotes lecture_notes(const Session& session) {
  const StageLanguage& language = stage_language(session.language);
  return session.lesson ? lesson_notes(*session.lesson, language) : talk_notes(session, language);
}

}  // namespace ghostforce
