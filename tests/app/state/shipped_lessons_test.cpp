// Every lesson that comes with the program can be done as it is meant, in each language.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "app/state/lesson_file.h"
#include "app/state/lesson_quantities.h"
#include "app/state/lesson_search.h"

namespace ghostforce::shipped_lessons_test {
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

// A number in a step's words, and where in the model it comes from.
struct Claim {
  std::string_view lesson;
  std::string_view step;
  bool is_revealed;  // else it is true when the step begins
  LessonQuantity quantity;
  int decimals;
};
constexpr std::array claims{
    Claim{"feel-a-wall", "twice", false, LessonQuantity::depth, 0},
    Claim{"feel-a-wall", "twice", false, LessonQuantity::force, 2},
    Claim{"feel-a-wall", "twice", true, LessonQuantity::depth, 0},
    Claim{"feel-a-wall", "twice", true, LessonQuantity::force, 2},
    Claim{"lose-a-motor", "upright", true, LessonQuantity::force, 2},
    Claim{"ghost", "press", true, LessonQuantity::slide, 0},
    Claim{"ghost", "gently", false, LessonQuantity::ghost_force, 2},
    Claim{"ghost", "gently", true, LessonQuantity::ghost_force, 2},
    Claim{"ghost", "one-newton", true, LessonQuantity::depth, 0},
    Claim{"ghost", "flatter", true, LessonQuantity::ghost_force, 2},
    Claim{"ghost", "steeper", false, LessonQuantity::handle_to_target, 0},
    Claim{"why", "share", false, LessonQuantity::force, 2},
    Claim{"why", "stiffer", false, LessonQuantity::ghost_force, 2},
    Claim{"why", "stiffer", true, LessonQuantity::ghost_force, 2},
    Claim{"cure", "predict", false, LessonQuantity::ghost_force, 2},
    Claim{"cure", "predict", true, LessonQuantity::force, 2},
    Claim{"wrong-guess", "softer", true, LessonQuantity::ghost_force, 2},
    Claim{"wrong-guess", "stiffer", true, LessonQuantity::ghost_force, 2},
    Claim{"measure-a-hand", "deeper", false, LessonQuantity::slide, 1},
    Claim{"measure-a-hand", "deeper", true, LessonQuantity::slide, 1},
    Claim{"measure-a-hand", "deeper", true, LessonQuantity::depth, 0},
    Claim{"your-own-wall", "where", true, LessonQuantity::ghost_force, 2},
    Claim{"your-own-wall", "where", true, LessonQuantity::angle, 0},
    Claim{"how-stiff-are-you", "belief", true, LessonQuantity::ghost_force, 2},
    Claim{"an-arm", "predict", false, LessonQuantity::depth, 0},
    Claim{"an-arm", "predict", false, LessonQuantity::slide, 1},
    Claim{"an-arm", "ghost", false, LessonQuantity::ghost_force, 2},
    Claim{"an-arm", "joint", false, LessonQuantity::slide, 1},
    Claim{"an-arm", "joint", true, LessonQuantity::slide, 1},
};

std::size_t number_of_step(const Lesson& lesson, std::string_view name) {
  const auto found = std::ranges::find(lesson.steps, name, &LessonStep::name);
  if (found == lesson.steps.end()) throw std::logic_error("no step named " + std::string(name));
  return static_cast<std::size_t>(found - lesson.steps.begin());
}

TEST(ShippedLessons, SayNumbersThatAreThoseOfTheModel) {
  for (const Claim& claim : claims) {
    const Lesson lesson = load_lesson(std::string(claim.lesson));
    const std::size_t step = number_of_step(lesson, claim.step);
    const auto& shown = claim.is_revealed ? *lesson.steps[step].reveal : *set_ups_at_start(lesson)[step];
    const StageMoment rest = stage_moment_at_rest(shown.scene.settings, shown.goal);
    const double value = lesson_quantity(claim.quantity).read({rest, shown.scene.settings});
    const std::string number = fmt::format("{:.{}f}", value, claim.decimals);
    for (const auto& [language, words] : lesson.words) {
      const LessonStepWords& said = words.steps[step];
      EXPECT_NE((said.text + said.right + said.wrong).find(number), std::string::npos)
          << claim.lesson << ", " << claim.step << " in " << language << " should say " << number;
    }
  }
}

TEST(ShippedLessons, SayHowMuchEnergyARoundGives) {
  const Lesson lesson = load_lesson("round-and-round");
  const auto expect_energy = [&](std::string_view step, double mJ) {
    LessonStep question;
    question.conditions = {{LessonQuantity::energy, mJ - 0.05, mJ + 0.05}};
    EXPECT_TRUE(examine_task(question, *lesson.steps[number_of_step(lesson, step)].reveal).solution) << step;
    for (const auto& [language, words] : lesson.words) {
      EXPECT_NE(words.steps[number_of_step(lesson, step)].right.find(fmt::format("{:.1f}", mJ)), std::string::npos);
    }
  };
  expect_energy("naive", 38.5);
  expect_energy("cure", 23.8);
}

TEST(ShippedLessons, AreInTheOrderOfTheirNumbers) {
  const std::vector<std::string_view> names = shipped_lesson_names();
  EXPECT_GE(names.size(), 9U);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(load_lesson(std::string(names[i])).number, static_cast<double>(i + 1)) << names[i];
  }
}

}  // namespace
}  // namespace ghostforce::shipped_lessons_test
