// The visitor's mode without a window: one lesson after another, and what counts as somebody who is there.
#include "app/state/kiosk_visit.h"

#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "app/state/apply.h"
#include "app/state/key_bindings.h"
#include "app/state/keys.h"
#include "app/state/lesson_file.h"
#include "app/state/lesson_guide.h"

namespace ghostforce::kiosk_visit_test {
namespace {

void press_key(Session& session, const KeyPress& press) {
  if (const std::optional<Action> action = action_of_key(press, false)) apply(session, *action);
}

class KioskVisitTest : public testing::Test {
 protected:
  KioskVisitTest() {
    session_.face = Face::stage;
    begin_kiosk_visit(session_, shipped_lessons());
  }
  const KioskVisit& visit() const { return *session_.kiosk_visit; }
  void touch() { follow_kiosk_visit(session_, {.has_acted = true}, 0.1); }
  void wait(double seconds, const std::optional<Vector<2>>& handle = {}) {
    constexpr int parts = 100;
    for (int i = 0; i < parts; ++i) follow_kiosk_visit(session_, {.handle = handle}, seconds / parts);
  }
  // To the last step of the lesson, by the key for it.
  void go_to_last_step() {
    const auto& lesson = session_.lesson->lesson;
    while (session_.lesson->step + 1 < lesson->steps.size()) next_lesson_step(session_);
    show_answer_in_lesson(session_);
    ASSERT_EQ(session_.lesson->lesson, lesson);
  }

  Session session_ = session_of(load_scene("wall45"));
};

TEST_F(KioskVisitTest, BeginsWithTheFirstStepAsItStands) {
  EXPECT_EQ(session_.lesson->lesson, shipped_lessons().front());
  EXPECT_EQ(session_.lesson->step, 0U);
  EXPECT_FALSE(session_.lesson->glide);
  EXPECT_EQ(session_.goal, shipped_lessons().front()->steps.front().set_up->goal);
}

TEST_F(KioskVisitTest, LessonsFollowOneAnotherInALoop) {
  for (int round = 0; round < 2; ++round) {
    for (const auto& lesson : shipped_lessons()) {
      ASSERT_EQ(session_.lesson->lesson, lesson);
      EXPECT_EQ(session_.lesson->step, 0U);
      go_to_last_step();
      next_lesson_step(session_);
      EXPECT_EQ(session_.dialog, Dialog::none);
    }
  }
}

TEST_F(KioskVisitTest, OneLessonComesOverAndOver) {
  begin_kiosk_visit(session_, {shipped_lessons()[2]});
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(session_.lesson->lesson, shipped_lessons()[2]);
    go_to_last_step();
    next_lesson_step(session_);
  }
}

TEST_F(KioskVisitTest, ARoundThatFollowsARoundGoesOn) {
  Lesson lesson = *shipped_lessons().front();
  auto round = std::make_shared<ghostforce::SetUp>(*lesson.steps.front().set_up);
  round->mode = StageMode::round;
  lesson.steps = {lesson.steps.front()};
  lesson.steps.front().set_up = round;
  begin_kiosk_visit(session_, {std::make_shared<const Lesson>(lesson)});
  EXPECT_EQ(session_.wanted_input, circling_hand.name);
  session_.wanted_input.reset();
  session_.circle_test.is_on = true;  // as the link to the circle says
  next_lesson_step(session_);
  EXPECT_EQ(session_.stage.mode, StageMode::round);
  EXPECT_FALSE(session_.wanted_input) << "the circle stays";
}

TEST_F(KioskVisitTest, EverythingIsAsAtTheStartAfterNinetySecondsWithoutAHand) {
  const Session before = session_;
  touch();
  go_to_last_step();
  next_lesson_step(session_);
  switch_to_next_language(session_);
  session_.settings.stiffnesses.k_r = 900.0;
  session_.goal = {0.01, 0.02};
  EXPECT_EQ(session_.lesson->lesson, shipped_lessons()[1]);
  EXPECT_EQ(session_.language, "es");
  wait(89.9);
  EXPECT_EQ(session_.lesson->lesson, shipped_lessons()[1]);
  EXPECT_EQ(visit().departures, 0U);
  wait(0.2);
  EXPECT_EQ(visit().departures, 1U);
  EXPECT_FALSE(visit().has_visitor);
  EXPECT_EQ(session_.lesson->lesson, before.lesson->lesson);
  EXPECT_EQ(session_.lesson->step, 0U);
  EXPECT_EQ(session_.lesson->steps, before.lesson->steps) << "no answers";
  EXPECT_EQ(session_.language, "en");
  EXPECT_EQ(session_.language, "en");
  EXPECT_EQ(session_.lesson_progress, before.lesson_progress);
  EXPECT_EQ(session_.settings, before.settings);
  EXPECT_EQ(session_.goal, before.goal);
  EXPECT_EQ(session_.stage.mode, before.stage.mode);
  EXPECT_FALSE(session_.lesson->glide);
  // What the end of a lesson would give back is still what was there at first.
  EXPECT_EQ(session_.lesson->before.settings, before.lesson->before.settings);
  EXPECT_EQ(session_.lesson->before.goal, before.lesson->before.goal);
}

TEST_F(KioskVisitTest, OneLongIntervalIsAsLongAsManyShortOnes) {
  touch();
  next_lesson_step(session_);
  follow_kiosk_visit(session_, {}, 3600.0);
  EXPECT_EQ(visit().departures, 1U);
  EXPECT_EQ(session_.lesson->step, 0U);
}

TEST_F(KioskVisitTest, ATouchIsEnoughToStay) {
  for (int i = 0; i < 20; ++i) {
    touch();
    next_lesson_step(session_);
    wait(80.0);
  }
  EXPECT_EQ(visit().departures, 0U);
}

TEST_F(KioskVisitTest, WhereNobodyWasNothingStartsAgain) {
  wait(1000.0);
  EXPECT_EQ(visit().departures, 0U);
}

TEST_F(KioskVisitTest, AHandleThatMovesIsAHandAndOneThatTremblesIsNone) {
  const Vector<2> at{0.01, 0.01};
  wait(3.0, at);
  EXPECT_FALSE(visit().has_visitor);
  wait(1.0, at + Vector<2>(0.0015, 0.0));
  EXPECT_FALSE(visit().has_visitor);
  wait(1.0, at + Vector<2>(0.0025, 0.0));
  EXPECT_TRUE(visit().has_visitor);
  // Whoever plays with the handle alone stays.
  for (int i = 0; i < 10; ++i) wait(60.0, at + Vector<2>(0.0, 0.01 * i));
  EXPECT_EQ(visit().departures, 0U);
  wait(91.0, at + Vector<2>(0.0, 0.0901));
  EXPECT_EQ(visit().departures, 1U);
  // It sinks once the motors are off: that is nobody.
  wait(1.5, at);
  wait(200.0, at);
  EXPECT_FALSE(visit().has_visitor);
}

TEST_F(KioskVisitTest, APointerThatIsThereAtOnceIsNoHand) {
  follow_kiosk_visit(session_, {.has_pointed = true}, 0.5);
  EXPECT_FALSE(visit().has_visitor);
  wait(2.0);
  follow_kiosk_visit(session_, {.has_pointed = true}, 0.5);
  EXPECT_TRUE(visit().has_visitor);
}

TEST_F(KioskVisitTest, ADeviceThatAppearsIsNoHand) {
  wait(5.0);
  wait(5.0, Vector<2>(0.02, 0.0));
  EXPECT_FALSE(visit().has_visitor);
}

TEST_F(KioskVisitTest, InvitesUntilSomebodyIsThere) {
  EXPECT_TRUE(invites_visitors(session_));
  touch();
  EXPECT_FALSE(invites_visitors(session_));
  wait(91.0);
  EXPECT_TRUE(invites_visitors(session_));
  // A step that asks something must not give the answer away.
  begin_kiosk_visit(session_, {shipped_lessons()[2]});
  ASSERT_NE(session_.lesson->lesson->steps.front().question, LessonQuestion::none);
  EXPECT_FALSE(invites_visitors(session_));
}

TEST_F(KioskVisitTest, TheLanguagesGoRound) {
  EXPECT_EQ(next_language(session_), "es");
  switch_to_next_language(session_);
  EXPECT_EQ(session_.language, "es");
  go_to_last_step();
  next_lesson_step(session_);
  EXPECT_EQ(session_.language, "es") << "in the next lesson too";
  switch_to_next_language(session_);
  EXPECT_EQ(session_.language, "en");
  // One that nobody speaks here is shown in English.
  session_.language = "xx";
  EXPECT_EQ(next_language(session_), "es");
  Lesson english = *shipped_lessons().front();
  english.words.erase("es");
  begin_kiosk_visit(session_, {std::make_shared<const Lesson>(english)});
  EXPECT_EQ(next_language(session_), "");
  switch_to_next_language(session_);
  EXPECT_EQ(session_.language, "xx") << "as it was";
}

TEST_F(KioskVisitTest, EscTurnsMotorsOffAndLeavesNothing) {
  const std::uint32_t offs = session_.offs_asked;
  press_key(session_, {.key = key::escape});
  EXPECT_TRUE(session_.lesson);
  EXPECT_EQ(session_.offs_asked, offs + 1);
}

}  // namespace
}  // namespace ghostforce::kiosk_visit_test
