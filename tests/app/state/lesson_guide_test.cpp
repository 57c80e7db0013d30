// The guide through a lesson, without a window: steps, answers, glides, what is not allowed, and what comes back.
#include "app/state/lesson_guide.h"

#include <gtest/gtest.h>

#include <memory>

#include "app/files/scene_file.h"
#include "app/state/apply.h"
#include "app/state/key_bindings.h"
#include "app/state/keys.h"
#include "app/state/lesson_file.h"
#include "app/state/permit.h"

namespace ghostforce::lesson_guide_test {
namespace {

void press_key(Session& session, const KeyPress& press) {
  if (const std::optional<Action> action = action_of_key(press, false)) apply(session, *action);
}

std::shared_ptr<const SetUp> set_up_at(const Vector<2>& goal, StrategyId active = StrategyId::naive,
                                       StageMode mode = StageMode::none) {
  SetUp set_up{.scene = load_scene("wall45"), .goal = goal, .face = Face::stage, .mode = mode};
  set_up.scene.settings.active = active;
  set_up.scene.goal.points.back() = goal;
  return std::make_shared<const SetUp>(set_up);
}

const Vector<2> outside{-0.01, 0.01};
const Vector<2> inside{0.01, -0.01};
const Vector<2> deep{0.02, -0.02};

// A text, a choice with a reveal, a guess, a task that goes on with what is there, three steps of Why?.
std::shared_ptr<const Lesson> lesson_for_test() {
  Lesson lesson;
  lesson.name = "test";
  lesson.number = 1;
  lesson.steps.resize(7);
  lesson.steps[0].set_up = set_up_at(outside);
  lesson.steps[0].controls = {LessonControl::hand};
  LessonStep& choice = lesson.steps[1];
  choice.set_up = set_up_at(outside);
  choice.question = LessonQuestion::choose;
  choice.right_answer = 1;
  choice.secrets = {LessonSecret::numbers};
  choice.reveal = set_up_at(inside);
  LessonStep& guess = lesson.steps[2];
  guess.set_up = set_up_at(deep);
  guess.question = LessonQuestion::guess;
  guess.within = 0.004;
  LessonStep& task = lesson.steps[3];
  task.question = LessonQuestion::task;
  task.controls = {LessonControl::strategies};
  task.conditions = {{.quantity = LessonQuantity::ghost_force, .greatest = 0.05}};
  task.with = StrategyId::anisotropic;
  for (std::size_t i = 4; i < 7; ++i) lesson.steps[i].set_up = set_up_at(deep, StrategyId::naive, StageMode::why);
  LessonWords words{.title = "Test", .about = "A test.", .steps = {}};
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    lesson.steps[i].name = "step " + std::to_string(i);
    words.steps.push_back({.text = "text", .answers = {}, .right = "right", .wrong = "wrong"});
  }
  words.steps[1].answers = {"one", "two", "three"};
  lesson.words.emplace("en", words);
  return std::make_shared<const Lesson>(lesson);
}

class LessonGuideTest : public testing::Test {
 protected:
  LessonGuideTest() {
    session.face = Face::workbench;
    before = session;
    begin_lesson(session, lesson_for_test());
  }
  const LessonRecord& record() const { return session.lesson_progress.lessons.at("test"); }
  void wait(double seconds) {
    for (double gone = 0.0; gone < seconds; gone += 0.05) {
      const StageMoment moment = stage_moment_at_rest(session.settings, session.goal);
      follow_lesson(session, {moment, session.settings, nullptr}, 0.05);
    }
  }
  void go_to(std::size_t step) {
    while (session.lesson->step < step) next_lesson_step(session);
    wait(1.5);
  }
  LessonState& lesson() { return *session.lesson; }
  LessonOutcome outcome() { return lesson_step_state(lesson()).outcome; }

  Session session = session_of(load_scene("wall45"));
  Session before = session;
};

TEST_F(LessonGuideTest, BeginsAStepAnew) {
  go_to(1);
  answer_in_lesson(session, 0);
  session.goal = deep;
  session.fits_view = false;
  const auto restarts = session.restarts_asked;
  press_key(session, {.key = key::r});
  EXPECT_EQ(session.goal, inside) << "as it was last stated, at once";
  EXPECT_EQ(session.restarts_asked, restarts + 1);
  EXPECT_TRUE(session.fits_view);
  EXPECT_EQ(lesson_step_state(*session.lesson).chosen, 0U) << "what was answered stays so";
  ASSERT_TRUE(permit(session, Restart{.with_scene_settings = true})) << "the settings are the lesson's";
}

TEST_F(LessonGuideTest, WhatTakesItsPlaceFindsFaceAndSpeedAsTheyWere) {
  leave_lesson(session);
  session.speed = 0.25;
  begin_lesson(session, lesson_for_test());
  EXPECT_EQ(session.speed, 1.0);
  abandon_lesson(session);
  EXPECT_EQ(session.speed, 0.25);
  EXPECT_EQ(session.face, before.face);
}

TEST_F(LessonGuideTest, AsksForTheMouseWhereAHandMovesByItself) {
  for (const InputChoice& hand : hands_moving_by_themselves) {
    session.wanted_input.reset();
    session.input = hand.name;
    begin_lesson(session, lesson_for_test());
    EXPECT_EQ(session.wanted_input, mouse_hand.name);
  }
  session.wanted_input.reset();
  session.input = "falcon";
  begin_lesson(session, lesson_for_test());
  EXPECT_FALSE(session.wanted_input) << "a hand at a device stays";
}

TEST_F(LessonGuideTest, LeadsTheHandLikeAHandAndNeverByAJump) {
  EXPECT_EQ(session.face, Face::stage);
  Vector<2> last = session.goal;
  EXPECT_EQ(last, before.goal) << "nothing has moved yet";
  double fastest = 0.0;
  int frames = 0;
  for (; session.lesson->glide && frames < 1000; ++frames) {
    wait(0.05);
    fastest = std::max(fastest, glm::distance(session.goal, last));
    last = session.goal;
  }
  EXPECT_EQ(session.goal, outside) << "exactly";
  EXPECT_EQ(frames, 20);
  // A minimum jerk's greatest speed is 15/8 of the mean one.
  EXPECT_LE(fastest, 1.9 * 0.05 * glm::distance(before.goal, outside));
}

TEST_F(LessonGuideTest, LeavesAHandAloneThatIsTakenHoldOf) {
  wait(0.3);
  session.goal = {0.0, 0.03};
  wait(2.0);
  EXPECT_EQ(session.goal, Vector<2>(0.0, 0.03));
}

TEST_F(LessonGuideTest, TakesAnAnswerOnce) {
  go_to(1);
  EXPECT_TRUE(is_hidden(session, LessonSecret::numbers));
  answer_in_lesson(session, 7);
  EXPECT_EQ(outcome(), LessonOutcome::open) << "there is no such answer";
  answer_in_lesson(session, 0);
  EXPECT_EQ(outcome(), LessonOutcome::wrong);
  EXPECT_FALSE(is_hidden(session, LessonSecret::numbers));
  answer_in_lesson(session, 1);
  EXPECT_EQ(outcome(), LessonOutcome::wrong) << "the first try counts";
  EXPECT_TRUE(record().right.empty());
  wait(1.5);
  EXPECT_EQ(session.goal, inside) << "revealed";
}

TEST_F(LessonGuideTest, GivesAnAnswerAwayWithoutAScore) {
  go_to(1);
  next_lesson_step(session);
  EXPECT_EQ(lesson().step, 1U) << "first the answer is shown";
  EXPECT_EQ(outcome(), LessonOutcome::shown);
  wait(1.5);
  EXPECT_EQ(session.goal, inside);
  next_lesson_step(session);
  EXPECT_EQ(lesson().step, 2U);
  EXPECT_TRUE(record().right.empty());
}

TEST_F(LessonGuideTest, KnowsAGoodGuess) {
  go_to(2);
  ASSERT_TRUE(session.stage.guess && session.stage.guess_is_open);
  session.stage.guess = stage_moment_at_rest(session.settings, deep).handle + Vector<2>(0.0, 0.0039);
  confirm_in_lesson(session);
  EXPECT_EQ(outcome(), LessonOutcome::right);
  EXPECT_NEAR(lesson_step_state(lesson()).missed_by.value_or(0.0), 0.0039, 1e-9);
  EXPECT_FALSE(session.stage.guess_is_open);
  previous_lesson_step(session);
  next_lesson_step(session);
  EXPECT_EQ(session.stage.guess, lesson_step_state(lesson()).guess) << "it is still there";
  EXPECT_FALSE(session.stage.guess_is_open);
}

TEST_F(LessonGuideTest, KnowsABadGuess) {
  go_to(2);
  session.stage.guess = stage_moment_at_rest(session.settings, deep).handle + Vector<2>(0.0, 0.0041);
  confirm_in_lesson(session);
  EXPECT_EQ(outcome(), LessonOutcome::wrong);
}

TEST_F(LessonGuideTest, SeesThatATaskIsDoneAndNotInPassing) {
  go_to(3);
  EXPECT_EQ(session.goal, deep) << "goes on with what is there";
  wait(2.0);
  EXPECT_EQ(outcome(), LessonOutcome::open);
  apply(session, ChooseStrategy{StrategyId::anisotropic});
  wait(0.5);
  apply(session, ChooseStrategy{StrategyId::naive});
  wait(0.5);
  EXPECT_EQ(outcome(), LessonOutcome::open) << "in passing";
  apply(session, ChooseStrategy{StrategyId::anisotropic});
  wait(1.0);
  EXPECT_EQ(outcome(), LessonOutcome::right);
}

TEST_F(LessonGuideTest, ATaskIsDoneWhileTheHandIsHeldButNotWhileAValueIsTurned) {
  go_to(3);
  apply(session, ChooseStrategy{StrategyId::anisotropic});
  session.is_editing = true;
  wait(2.0);
  EXPECT_EQ(outcome(), LessonOutcome::open) << "the value may be on its way";
  session.drags_goal = true;
  wait(1.0);
  EXPECT_EQ(outcome(), LessonOutcome::right);
}

TEST_F(LessonGuideTest, AddsOneForceAfterAnotherInWhy) {
  const int expected[] = {2, 3, 4};
  for (std::size_t i = 0; i < 3; ++i) {
    go_to(4 + i);
    EXPECT_EQ(session.stage.mode, StageMode::why);
    EXPECT_EQ(session.stage.why_step, expected[i]);
  }
  go_to(6);
  previous_lesson_step(session);
  EXPECT_EQ(session.stage.why_step, 3);
}

TEST_F(LessonGuideTest, GoesBackToWhatWasLastStated) {
  go_to(1);
  answer_in_lesson(session, 1);
  wait(1.5);
  go_to(3);
  apply(session, ChooseStrategy{StrategyId::anisotropic});
  previous_lesson_step(session);
  wait(1.5);
  EXPECT_EQ(session.goal, deep);
  EXPECT_EQ(session.settings.active, StrategyId::naive);
  previous_lesson_step(session);
  wait(1.5);
  EXPECT_EQ(session.goal, inside) << "it has been answered";
  EXPECT_EQ(outcome(), LessonOutcome::right);
  previous_lesson_step(session);
  wait(1.5);
  EXPECT_EQ(session.goal, outside);
  previous_lesson_step(session);
  EXPECT_EQ(lesson().step, 0U);
  EXPECT_EQ(lesson().furthest, 3U);
}

// Every key of the table, in a step that allows nothing.
TEST_F(LessonGuideTest, DoesNotDoWhatAStepDoesNotAllow) {
  go_to(4);
  for (const KeyBinding& binding : key_table()) {
    using LeadOn = std::variant<NextStep, PreviousStep, Confirm, Escape>;
    const bool leads_on =
        binding.action && std::visit([]<typename A>(const A&) { return is_one_of<A, LeadOn>; }, *binding.action);
    if (leads_on) continue;
    Session pressed = session;
    press_key(pressed, {.key = binding.key, .modifiers = binding.modifiers});
    EXPECT_EQ(pressed.settings, session.settings) << binding.sentence;
    EXPECT_EQ(pressed.goal, session.goal) << binding.sentence;
    EXPECT_EQ(pressed.stage.mode, session.stage.mode) << binding.sentence;
    EXPECT_EQ(pressed.face, session.face) << binding.sentence;
    EXPECT_EQ(pressed.paused, session.paused) << binding.sentence;
    const bool begins_anew = binding.key == key::r && binding.modifiers == 0;  // the step
    EXPECT_EQ(pressed.restarts_asked, session.restarts_asked + (begins_anew ? 1 : 0)) << binding.sentence;
    EXPECT_EQ(pressed.lesson->step, session.lesson->step) << binding.sentence;
  }
}

TEST_F(LessonGuideTest, DigitsAnswerWhileAQuestionIsOpen) {
  go_to(1);
  press_key(session, {.key = key::digit_2});
  EXPECT_EQ(outcome(), LessonOutcome::right);
  EXPECT_EQ(session.settings.active, StrategyId::naive);
  press_key(session, {.key = key::digit_3});
  EXPECT_EQ(session.settings.active, StrategyId::naive) << "strategies are not among its controls";
}

TEST_F(LessonGuideTest, GivesBackWhatThePersonHad) {
  go_to(4);
  press_key(session, {.key = key::escape});
  EXPECT_FALSE(session.lesson);
  EXPECT_EQ(session.settings, before.settings);
  EXPECT_EQ(session.goal, before.goal);
  EXPECT_EQ(session.face, Face::workbench);
  EXPECT_EQ(session.stage.mode, StageMode::none);
  EXPECT_FALSE(session.stage.guess);
}

TEST_F(LessonGuideTest, EscapeTurnsMotorsOffFirst) {
  session.motors_may_push = true;
  session.dialog = Dialog::doctor;
  const std::uint32_t offs = session.offs_asked;
  press_key(session, {.key = key::escape});
  EXPECT_EQ(session.offs_asked, offs + 1);
  EXPECT_EQ(session.dialog, Dialog::doctor) << "where the reason is told";
  EXPECT_TRUE(session.lesson);
  session.motors_may_push = false;
  press_key(session, {.key = key::escape});
  EXPECT_EQ(session.dialog, Dialog::none);
  EXPECT_TRUE(session.lesson);
  press_key(session, {.key = key::escape});
  EXPECT_FALSE(session.lesson);
}

TEST_F(LessonGuideTest, RemembersWhatWasDone) {
  go_to(1);
  answer_in_lesson(session, 1);
  while (session.lesson) next_lesson_step(session);
  EXPECT_EQ(session.dialog, Dialog::lessons);
  const LessonRecord& record = session.lesson_progress.lessons.at("test");
  EXPECT_TRUE(record.is_finished);
  EXPECT_EQ(record.farthest, 6U);
  EXPECT_EQ(record.right, std::set<std::string>{"step 1"});
  // A worse visit takes nothing away.
  begin_lesson(session, lesson_for_test());
  leave_lesson(session);
  EXPECT_EQ(session.lesson_progress.lessons.at("test").right, std::set<std::string>{"step 1"});
  EXPECT_TRUE(session.lesson_progress.lessons.at("test").is_finished);
}

TEST_F(LessonGuideTest, OneLessonLeadsOnToTheNextThatIsNotDone) {
  const auto& all = shipped_lessons();
  const auto go_through = [&](std::size_t number) {
    begin_lesson(session, all[number]);
    while (session.lesson) next_lesson_step(session);
  };
  leave_lesson(session);
  EXPECT_EQ(lesson_to_go_on_with(session), 0U);
  go_through(2);
  EXPECT_EQ(lesson_to_go_on_with(session), 3U) << "not the first again";
  go_through(3);
  go_through(1);
  EXPECT_EQ(lesson_to_go_on_with(session), 4U) << "2 and 3 are done";
  go_through(all.size() - 1);
  EXPECT_EQ(lesson_to_go_on_with(session), 0U);
  for (std::size_t i = 0; i < all.size(); ++i) go_through(i);
  EXPECT_EQ(lesson_to_go_on_with(session), 0U) << "all are done, and it begins again";
}

}  // namespace
}  // namespace ghostforce::lesson_guide_test
