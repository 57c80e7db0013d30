// Every lesson that comes with the program can be done as it is meant, in each language.
#include <gtest/gtest.h>

#include "app/lessons/lesson_check.h"
#include "app/lessons/lesson_file.h"

namespace ghostforce {
namespace {

class ShippedLesson : public testing::TestWithParam<std::string_view> {
 protected:
  const Lesson lesson_ = load_lesson(std::string(GetParam()));
};

INSTANTIATE_TEST_SUITE_P(All, ShippedLesson, testing::ValuesIn(shipped_lesson_names()), [](const auto& tested) {
  std::string name(tested.param);
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST_P(ShippedLesson, CanBeDoneStepByStep) {
  const std::vector<LessonStepFinding> findings = examine_lesson(lesson_);
  ASSERT_EQ(findings.size(), lesson_.steps.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    EXPECT_TRUE(findings[i].is_good) << lesson_.steps[i].name << ": " << findings[i].words;
  }
}

TEST_P(ShippedLesson, IsInEachLanguage) {
  EXPECT_EQ(languages_missing_in(lesson_), std::vector<std::string_view>{});
}

TEST_P(ShippedLesson, IsShortAndAsksAndLetsTheHandAct) {
  EXPECT_GE(lesson_.steps.size(), 4U);
  EXPECT_LE(lesson_.steps.size(), 8U);
  const auto predicts = [](const LessonStep& step) {
    return step.question == LessonQuestion::choose || step.question == LessonQuestion::guess;
  };
  const auto lets_hand_act = [](const LessonStep& step) { return step.controls.contains(LessonControl::hand); };
  EXPECT_TRUE(std::ranges::any_of(lesson_.steps, predicts));
  EXPECT_TRUE(std::ranges::any_of(lesson_.steps, lets_hand_act));
}

TEST(ShippedLessons, AreInTheOrderOfTheirNumbers) {
  const std::vector<std::string_view> names = shipped_lesson_names();
  EXPECT_EQ(names.size(), 9U);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(load_lesson(std::string(names[i])).number, static_cast<double>(i + 1)) << names[i];
  }
}

}  // namespace
}  // namespace ghostforce
