// What a lecturer reads beside the stage.
#include "app/state/lecture_notes.h"

#include <gtest/gtest.h>

#include <string>

#include "app/files/scene_file.h"
#include "app/state/apply.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"
#include "app/state/stage_language.h"
#include "app/state/talk.h"

namespace ghostforce::lecture_notes_test {
namespace {

class LectureNotesTest : public testing::Test {
 protected:
  Session session = session_of(load_scene("wall45"));
};

TEST_F(LectureNotesTest, EachStepOfTheTalkHasItsOwnAndNamesTheNext) {
  for (const StageLanguage* const language : stage_languages) {
    session = session_of(load_scene("wall45"));
    session.language = language->code;
    const auto& steps = language->lecture.steps;
    ASSERT_EQ(steps.size(), talk_length());
    EXPECT_EQ(lecture_notes(session).words, language->lecture.begins);
    EXPECT_EQ(lecture_notes(session).next, filled(language->lecture.next, steps.front().title));
    for (std::size_t i = 0; i < steps.size(); ++i) {
      apply(session, NextStep{});
      const LectureNotes notes = lecture_notes(session);
      EXPECT_NE(notes.title.find(steps[i].title), std::string::npos) << notes.title;
      EXPECT_NE(notes.title.find(std::to_string(i + 1)), std::string::npos) << notes.title;
      EXPECT_EQ(notes.words, steps[i].notes);
      EXPECT_EQ(notes.next, i + 1 < steps.size() ? filled(language->lecture.next, steps[i + 1].title)
                                                 : std::string(language->lecture.last));
    }
    apply(session, PreviousStep{});
    EXPECT_EQ(lecture_notes(session).words, steps[steps.size() - 2].notes);
  }
}

TEST_F(LectureNotesTest, ALessonsNotesGiveTheAnswerBeforeTheRoomDoes) {
  for (const auto& lesson : shipped_lessons()) {
    begin_lesson(session, lesson);
    const LessonWords& words = words_in(*lesson, session.language);
    for (std::size_t step = 0; step < lesson->steps.size(); ++step) {
      show_lesson_step(session, step);
      const LectureNotes notes = lecture_notes(session);
      EXPECT_NE(notes.title.find(words.title), std::string::npos);
      EXPECT_NE(notes.words.find(words.steps[step].right), std::string::npos);
      if (lesson->steps[step].question == LessonQuestion::choose) {
        const std::size_t right = lesson->steps[step].right_answer;
        EXPECT_NE(notes.words.find(words.steps[step].answers[right]), std::string::npos) << notes.words;
        EXPECT_NE(notes.words.find(std::to_string(right + 1)), std::string::npos) << notes.words;
      }
      const bool is_last = step + 1 == lesson->steps.size();
      EXPECT_NE(notes.next.find(is_last ? english_stage.lecture.last : words.steps[step + 1].text), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace ghostforce::lecture_notes_test
