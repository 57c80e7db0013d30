// The hand as it is measured on request, without a window: what is waited for, what counts, when it gives up, and what
// becomes of the number.
#include "app/state/stiffness_probe_guide.h"

#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "app/state/apply.h"
#include "app/state/lesson_guide.h"
#include "app/state/session.h"

namespace ghostforce::stiffness_probe_test {
namespace {

constexpr double look_s = 0.05;  // between two frames
constexpr HandEstimate hand_of_310{.why = HandUnknown::none, .k_u = 310.0, .sigma = 25.0, .mass = 0.4, .damping = 5.0};

class StiffnessProbeTest : public testing::Test {
 protected:
  StiffnessProbeTest() { apply(session, ShowFace{Face::stage}); }

  const StiffnessProbe& probe() const { return session.stiffness_probe; }
  void press_key() { apply(session, ToggleMode{StageMode::measure}); }

  // The servo tells of an estimate at each look, whose window is full after `fills_s` in the wall.
  void wait(double seconds, const HandEstimate& estimate, bool is_in_wall = true, double fills_s = 2.0) {
    const int looks = static_cast<int>(seconds / look_s + 0.5);
    for (int i = 0; i < looks; ++i) {
      now.time_s += look_s;
      in_wall_s = is_in_wall ? in_wall_s + look_s : 0.0;
      for (auto& strategy : now.strategies) strategy.in_contact = is_in_wall;
      const HandReading reading{.filled = std::min(1.0, in_wall_s / fills_s), .estimate = estimate, .at_s = now.time_s};
      follow_stiffness_probe(session, now, motors, reading);
    }
  }

  Session session = session_of(load_scene("wall45"));
  Snapshot now;
  MotorReport motors;
  double in_wall_s = 0.0;
};

TEST_F(StiffnessProbeTest, IsKnownAfterAWindowOfTwoSeconds) {
  EXPECT_FALSE(wants_tones(session));
  press_key();
  EXPECT_TRUE(wants_tones(session));
  wait(1.0, {.why = HandUnknown::collecting});
  EXPECT_NEAR(probe().filled, 0.5, 0.03) << "the ring; the first look is where it begins";
  EXPECT_TRUE(probe().is_running());
  wait(1.2, hand_of_310);
  EXPECT_TRUE(probe().is_known());
  EXPECT_EQ(probe().estimate, hand_of_310);
  EXPECT_FALSE(wants_tones(session)) << "the motor is quiet again";
}

// Where the belief follows the hand, the tones have long been there: what was measured before the press does not count.
TEST_F(StiffnessProbeTest, AnOlderEstimateDoesNotCount) {
  now.time_s = 100.0;
  in_wall_s = 100.0;
  press_key();
  wait(1.9, hand_of_310);
  EXPECT_TRUE(probe().is_running());
  EXPECT_GT(probe().filled, 0.8);
  EXPECT_LT(probe().filled, 1.0);
  wait(0.3, hand_of_310);
  EXPECT_TRUE(probe().is_known());
}

TEST_F(StiffnessProbeTest, WaitsForAHandThatIsNotInTheWall) {
  press_key();
  wait(60.0, {.why = HandUnknown::no_contact}, false);
  EXPECT_TRUE(probe().is_running());
  EXPECT_EQ(probe().why, HandUnknown::no_contact);
  EXPECT_EQ(probe().filled, 0.0);
  wait(2.2, hand_of_310);
  EXPECT_TRUE(probe().is_known());
}

TEST_F(StiffnessProbeTest, WaitsForMotorsThatAreOff) {
  motors.has_motors = true;
  motors.state = SafetyState::off;
  press_key();
  wait(10.0, {.why = HandUnknown::no_tones});
  EXPECT_EQ(probe().why, HandUnknown::no_tones);
  EXPECT_TRUE(probe().is_running());
  motors.state = SafetyState::on;
  wait(2.2, hand_of_310);
  EXPECT_TRUE(probe().is_known());
}

TEST_F(StiffnessProbeTest, PausedTimeDoesNotCount) {
  press_key();
  wait(1.0, {.why = HandUnknown::collecting});
  for (int i = 0; i < 1000; ++i) {
    follow_stiffness_probe(session, now, motors, {.filled = 0.5, .estimate = {}, .at_s = now.time_s});
  }
  EXPECT_TRUE(probe().is_running());
  wait(1.2, hand_of_310);
  EXPECT_TRUE(probe().is_known());
}

TEST_F(StiffnessProbeTest, GivesUpAfterSixSecondsAndSaysWhy) {
  press_key();
  const HandEstimate shaky{.why = HandUnknown::too_much_tremor, .k_u = 300.0, .sigma = 150.0};
  wait(5.9, shaky);
  EXPECT_TRUE(probe().is_running());
  wait(0.3, shaky);
  EXPECT_EQ(probe().stage, StiffnessProbe::Stage::done);
  EXPECT_EQ(probe().why, HandUnknown::too_much_tremor);
  EXPECT_FALSE(probe().estimate.has_number()) << "a number that is not to be relied on is not shown";
  EXPECT_FALSE(wants_tones(session));
}

TEST_F(StiffnessProbeTest, WhoLeavesTheWallAgainAndAgainIsToldSo) {
  press_key();
  for (int i = 0; i < 4; ++i) {
    wait(1.6, {.why = HandUnknown::collecting});
    wait(0.2, {.why = HandUnknown::no_contact}, false);
  }
  EXPECT_EQ(probe().stage, StiffnessProbe::Stage::done);
  EXPECT_EQ(probe().why, HandUnknown::no_contact);
}

TEST_F(StiffnessProbeTest, EnterHasTheRendererBelieveTheNumberAndThenMeasuresAgain) {
  session.settings.stiffnesses.chosen_tracking_ratio = 2.0;
  press_key();
  apply(session, GoOn{});
  EXPECT_TRUE(probe().is_running()) << "there is nothing yet";
  wait(2.2, hand_of_310);
  const double rho = 1.0 + session.settings.stiffnesses.k_r / 310.0;
  apply(session, GoOn{});
  EXPECT_EQ(session.settings.stiffnesses.believed_k_u, 310.0);
  EXPECT_EQ(tracking_ratio(session.settings.stiffnesses), rho) << "the ratio that was chosen would have hidden it";
  EXPECT_TRUE(stiffness_probe_is_believed(session));
  apply(session, GoOn{});
  EXPECT_TRUE(probe().is_running());
  ASSERT_TRUE(probe().before) << "what to compare with";
  EXPECT_EQ(*probe().before, hand_of_310);
}

TEST_F(StiffnessProbeTest, ThereIsNothingToBelieveWhereNothingIsKnown) {
  const Settings before = session.settings;
  press_key();
  believe_stiffness_probe(session);
  wait(7.0, {.why = HandUnknown::at_limit});
  believe_stiffness_probe(session);
  EXPECT_EQ(session.settings, before);
}

TEST_F(StiffnessProbeTest, EndsWithItsMode) {
  press_key();
  wait(1.0, {.why = HandUnknown::collecting});
  press_key();
  EXPECT_EQ(probe().stage, StiffnessProbe::Stage::off);
  EXPECT_FALSE(wants_tones(session));
  press_key();
  apply(session, ShowFace{Face::workbench});
  EXPECT_FALSE(wants_tones(session));
}

TEST_F(StiffnessProbeTest, GoesOnAfterARestart) {
  now.time_s = 50.0;
  press_key();
  wait(1.0, {.why = HandUnknown::collecting});
  now.time_s = 0.0;
  wait(1.9, hand_of_310);
  EXPECT_TRUE(probe().is_running()) << "the window begins anew";
  wait(0.3, hand_of_310);
  EXPECT_TRUE(probe().is_known());
}

// A lesson waits for its button, compares within a step and the next, and does not take over what it measures.
TEST_F(StiffnessProbeTest, InALessonItsButtonMeasures) {
  Lesson lesson;
  lesson.name = "test";
  lesson.steps.resize(2);
  const Scene scene = load_scene("wall45");
  lesson.steps[0].set_up = std::make_shared<const ghostforce::SetUp>(ghostforce::SetUp{
      .scene = scene, .goal = scene.goal.points.back(), .face = Face::stage, .mode = StageMode::measure});
  LessonStep& task = lesson.steps[1];
  task.question = LessonQuestion::task;
  task.controls = {LessonControl::hand};
  task.conditions = {{.quantity = LessonQuantity::hand, .greatest = 400.0}};
  for (LessonStep& step : lesson.steps) step.name = "step";
  lesson.words.emplace("en", LessonWords{.title = "Test", .about = "A test.", .steps = {{}, {}}});
  EXPECT_EQ(mode_of_step(lesson, 1), StageMode::measure) << "it stays where nothing else is stated";
  begin_lesson(session, std::make_shared<const Lesson>(lesson));
  EXPECT_FALSE(wants_tones(session));
  const Settings before = session.settings;
  const auto press = [&] { apply(session, PressMeasuringButton{}); };
  press();
  wait(2.2, hand_of_310);
  ASSERT_TRUE(probe().is_known());
  press();
  EXPECT_TRUE(probe().is_running()) << "again, and nothing is believed";
  EXPECT_EQ(session.settings, before);
  wait(2.2, hand_of_310);

  next_lesson_step(session);
  EXPECT_EQ(probe().stage, StiffnessProbe::Stage::off);
  EXPECT_EQ(probe().before, hand_of_310);
  const auto follow = [&](double seconds) {
    const StageMoment moment = stage_moment_at_rest(session.settings, session.goal);
    const auto k_u = probe().is_known() ? std::optional(probe().estimate.k_u) : std::nullopt;
    for (double gone = 0.0; gone < seconds; gone += look_s) {
      follow_lesson(session, {.moment = moment, .settings = session.settings, .hand_k_u = k_u}, look_s);
    }
  };
  follow(2.0);
  EXPECT_EQ(lesson_step_state(*session.lesson).outcome, LessonOutcome::open) << "of the step before";
  press();
  wait(2.2, hand_of_310);
  follow(2.0);
  EXPECT_EQ(lesson_step_state(*session.lesson).outcome, LessonOutcome::right);
}

}  // namespace
}  // namespace ghostforce::stiffness_probe_test
