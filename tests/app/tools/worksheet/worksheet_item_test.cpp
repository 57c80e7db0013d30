// What a worksheet asks, before anything has a place on paper.
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "app/state/lesson_file.h"
#include "app/tools/worksheet/worksheet_item.h"

namespace ghostforce::worksheet_item_test {
namespace {

std::vector<WorksheetItem> items_of(std::string_view lesson, WorksheetSide side) {
  return worksheet_items(load_lesson(std::string(lesson)), "en", side);
}

TEST(WorksheetItems, AskWhatTheLessonAsks) {
  const std::vector<WorksheetItem> items = items_of("ghost", WorksheetSide::questions);
  ASSERT_EQ(items.size(), 7U);
  EXPECT_EQ(items[0].boxes.size(), 3U) << "a choice";
  EXPECT_EQ(items[0].lines.front().words, "Because");
  EXPECT_EQ(items[3].boxes.front().words, "Done on the screen") << "a task";
  EXPECT_EQ(items[5].note, "Draw the handle where you think it will come to rest.") << "a guess";
  EXPECT_GT(items[5].picture_share, items[0].picture_share) << "there is room to draw";
  for (const WorksheetItem& item : items) {
    for (const WorksheetBox& box : item.boxes) EXPECT_FALSE(box.is_ticked);
  }
}

TEST(WorksheetItems, TickTheRightAnswerAndSayWhatTheLessonSays) {
  const Lesson lesson = load_lesson("ghost");
  const std::vector<WorksheetItem> items = items_of("ghost", WorksheetSide::answers);
  ASSERT_EQ(items.size(), lesson.steps.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const LessonStepWords& words = lesson.words.at("en").steps[i];
    EXPECT_EQ(items[i].text, words.text);
    EXPECT_EQ(items[i].note, words.wrong);
    EXPECT_TRUE(items[i].lines.empty());
    for (std::size_t k = 0; k < items[i].boxes.size(); ++k) {
      EXPECT_EQ(items[i].boxes[k].is_ticked, k == lesson.steps[i].right_answer) << i;
    }
  }
}

// These texts follow a question, and explain its answer.
TEST(WorksheetItems, LeaveToTheScreenWhatIsToldAfterAQuestion) {
  const std::vector<WorksheetItem> items = items_of("why", WorksheetSide::questions);
  ASSERT_EQ(items.size(), 4U);
  EXPECT_EQ(items[1].number, "2–6");
  EXPECT_EQ(items[1].text, "");
  EXPECT_EQ(items[1].lines.front().words, "Look at the screen. What do you see?");
  EXPECT_EQ(items[1].lines.size(), 3U) << "five steps, and room to write about three of them";
  EXPECT_EQ(items[2].number, "7");
  EXPECT_EQ(items_of("ghost", WorksheetSide::questions)[6].lines.front().words,
            "Try it on the screen. What do you see?");
  EXPECT_NE(items_of("feel-a-wall", WorksheetSide::questions)[0].text, "") << "before the first question";
}

// The picture of a later step is what an earlier question was about.
TEST(WorksheetItems, HideTheHandleWhereAPictureWouldAnswerAQuestionAbove) {
  const auto hidden = [](std::string_view lesson) {
    std::set<std::string> numbers;
    for (const WorksheetItem& item : items_of(lesson, WorksheetSide::questions)) {
      if (item.hides_handle && item.picture_share > 0.0) numbers.insert(item.number);
    }
    return numbers;
  };
  EXPECT_EQ(hidden("ghost"), (std::set<std::string>{"3", "4", "5"}));
  EXPECT_EQ(hidden("why"), (std::set<std::string>{"7", "8"})) << "the force was a secret";
  EXPECT_EQ(hidden("cure"), (std::set<std::string>{"4"}));
  EXPECT_EQ(hidden("measure-a-hand"), (std::set<std::string>{})) << "what is measured is seen from the beginning";
  for (const WorksheetItem& item : items_of("ghost", WorksheetSide::answers)) EXPECT_FALSE(item.hides_handle);
}

TEST(WorksheetPhrases, AreThereInEachLanguageOfTheLessons) {
  for (const auto& [language, words] : load_lesson("ghost").words) {
    EXPECT_EQ(worksheet_phrases(language).language, language);
  }
  EXPECT_EQ(worksheet_phrases("xx").language, "en");
}

}  // namespace
}  // namespace ghostforce::worksheet_item_test
