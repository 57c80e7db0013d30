// What the search says of tasks that are easy, hard and impossible.
#include "app/state/lesson_search.h"

#include <gtest/gtest.h>

#include "app/files/scene_keys.h"
#include "app/state/lesson_quantities.h"
#include "app/state/set_up.h"
#include "core/scene_shape.h"

namespace ghostforce::lesson_search_test {
namespace {

SetUp wall45(std::string_view options = "") {
  return read_set_up_line("ghostforce run wall45 " + std::string(options));
}

using StageSetUp = SetUp;  // in a test, SetUp is a function of GoogleTest

std::shared_ptr<const StageSetUp> shared(StageSetUp set_up) {
  return std::make_shared<const StageSetUp>(std::move(set_up));
}

LessonStep task(std::set<LessonControl> controls, std::vector<LessonCondition> conditions) {
  LessonStep step;
  step.question = LessonQuestion::task;
  step.controls = std::move(controls);
  step.conditions = std::move(conditions);
  return step;
}

void expect_done(const LessonStep& step, const SetUp& by) {
  const Settings& settings = by.scene.settings;
  EXPECT_TRUE(is_done(step, {stage_moment_at_rest(settings, by.goal), settings})) << set_up_line(by);
}

constexpr LessonCondition no_ghost{.quantity = LessonQuantity::ghost_force, .greatest = 0.01};

TEST(LessonSearch, FindsWhatOneControlCanDo) {
  const LessonStep by_hand = task({LessonControl::hand}, {{.quantity = LessonQuantity::depth, .least = 25.0}});
  const TaskFinding found = examine_task(by_hand, wall45());
  EXPECT_FALSE(found.is_met_at_start);
  ASSERT_TRUE(found.solution);
  expect_done(by_hand, *found.solution);
  EXPECT_EQ(found.solution->scene.settings, wall45().scene.settings) << "nothing else was touched";

  const LessonStep by_motor = task({LessonControl::motor}, {no_ghost});
  const TaskFinding turned = examine_task(by_motor, wall45());
  ASSERT_TRUE(turned.solution);
  expect_done(by_motor, *turned.solution);
  EXPECT_EQ(turned.solution->goal, wall45().goal);

  LessonStep by_strategy = task({LessonControl::strategies}, {no_ghost});
  by_strategy.with = StrategyId::anisotropic;
  const TaskFinding cured = examine_task(by_strategy, wall45());
  ASSERT_TRUE(cured.solution);
  EXPECT_EQ(cured.solution->scene.settings.active, StrategyId::anisotropic);
}

TEST(LessonSearch, PutsTheMotorAtTheOtherJoint) {
  const auto start = read_set_up_line("ghostforce run arm --set wall.normal_deg=45 --goal-mm=-14,-14");
  const LessonStep by_joint =
      task({LessonControl::motor}, {no_ghost, {.quantity = LessonQuantity::force, .least = 2.0}});
  const TaskFinding found = examine_task(by_joint, start);
  EXPECT_FALSE(found.is_met_at_start);
  ASSERT_TRUE(found.solution);
  expect_done(by_joint, *found.solution);
  EXPECT_EQ(found.solution->scene.settings, with_other_motor(start.scene.settings)) << "nothing else was touched";
  EXPECT_NE(set_up_line(*found.solution).find("--set device.motor=elbow"), std::string::npos);
  EXPECT_FALSE(examine_task(task({}, by_joint.conditions), start).solution);
}

TEST(LessonSearch, FindsANarrowPlaceOnASlider) {
  LessonStep step = task({}, {{.quantity = LessonQuantity::slide, .greatest = 1e-4}});
  step.slider = LessonSlider{find_scene_key("user.believed_k_u_N_per_m"), 50.0, 800.0};
  const auto start = wall45("--set user.k_u_N_per_m=333 --strategy anisotropic");
  const TaskFinding found = examine_task(step, wall45("--set user.believed_k_u_N_per_m=100 --strategy anisotropic"));
  EXPECT_FALSE(found.is_met_at_start);
  ASSERT_TRUE(found.solution);
  EXPECT_EQ(found.solution->scene.settings.stiffnesses.believed_k_u, 200.0) << "in as few digits as will do";
  EXPECT_TRUE(examine_task(step, start).is_met_at_start) << "the belief is right where none is given";
}

TEST(LessonSearch, FindsNothingWhereThereIsNothing) {
  // The ghost force of naive rendering depends on the depth alone.
  const LessonStep too_few =
      task({LessonControl::hand}, {no_ghost, {.quantity = LessonQuantity::depth, .least = 10.0}});
  EXPECT_FALSE(examine_task(too_few, wall45()).solution);
  LessonStep no_switch = task({LessonControl::hand}, {no_ghost});
  no_switch.with = StrategyId::anisotropic;
  EXPECT_FALSE(examine_task(no_switch, wall45()).solution) << "nobody can switch to the cure";
  const LessonStep rounds = task({LessonControl::hand}, {{.quantity = LessonQuantity::turns, .least = 1.0}});
  EXPECT_FALSE(examine_task(rounds, wall45()).solution) << "the hand does not go round";
}

TEST(LessonSearch, LetsTheHandGoRound) {
  const LessonStep wait =
      task({LessonControl::hand}, {{.quantity = LessonQuantity::turns, .least = 3.0},
                                   {.quantity = LessonQuantity::energy, .least = 38.0, .greatest = 39.0}});
  const TaskFinding found = examine_task(wait, wall45("--mode round"));
  EXPECT_FALSE(found.is_met_at_start);
  ASSERT_TRUE(found.solution);
  EXPECT_EQ(found.solution->goal, wall45().goal) << "waiting is enough";
}

TEST(LessonSearch, KnowsWhatEachStepBeginsWith) {
  const auto first = shared(wall45());
  const auto revealed = shared(wall45("--strategy full"));
  Lesson lesson;
  lesson.steps.resize(3);
  lesson.steps[0].set_up = first;
  lesson.steps[1].reveal = revealed;
  EXPECT_EQ(set_ups_at_start(lesson), (std::vector<const StageSetUp*>{first.get(), first.get(), revealed.get()}));
}

TEST(LessonSearch, KnowsWhatCanBeGuessed) {
  LessonStep guess;
  guess.within = 0.004;
  EXPECT_TRUE(can_be_guessed(guess, wall45()));
  EXPECT_FALSE(can_be_guessed(guess, wall45("--goal-mm=-10,10"))) << "in front of the wall the handle is at the hand";
  guess.within = 0.05;
  EXPECT_FALSE(can_be_guessed(guess, wall45())) << "the ring begins nearer than that";
}

}  // namespace
}  // namespace ghostforce::lesson_search_test
