// What one step of undo is: a setting, a drag of the goal, a run of key presses that move it; and what is none.

#include <memory>

#include <gtest/gtest.h>

#include "app/state/undo.h"

namespace ghostforce::undo_test {
namespace {

class UndoTest : public testing::Test {
 protected:
  void nudge(double x) {
    now_.goal.x = x;
    history_.note(now_, false);
  }
  void drag(double x) {
    for (const double share : {0.3, 0.6, 1.0}) {
      now_.goal.x = share * x;
      history_.note(now_, true);
    }
    history_.note(now_, false);
  }
  void set_stiffness(double k_r) {
    now_.settings.stiffnesses.k_r = k_r;
    history_.note(now_, false);
  }
  double goal_after_undo() {
    const auto state = history_.undo();
    EXPECT_TRUE(state);
    if (state) now_ = *state;
    return now_.goal.x;
  }
  bool has_more() const { return history_.before() != nullptr; }

  UndoState now_{.scene = std::make_shared<const Scene>(), .settings = {}, .goal_is_chosen = true};
  UndoHistory history_{now_};
};

TEST_F(UndoTest, EachDragOfTheGoalIsOneStep) {
  drag(0.01);
  drag(0.02);
  EXPECT_EQ(goal_after_undo(), 0.01);
  EXPECT_EQ(goal_after_undo(), 0.0);
  EXPECT_FALSE(has_more());
}

TEST_F(UndoTest, ARunOfKeyPressesIsOneStep) {
  for (int i = 1; i <= 30; ++i) nudge(0.001 * i);
  EXPECT_EQ(goal_after_undo(), 0.0);
  EXPECT_FALSE(has_more());
}

TEST_F(UndoTest, ARunOfKeyPressesEndsWithAnyOtherChange) {
  nudge(0.001);
  set_stiffness(777.0);
  nudge(0.002);
  nudge(0.003);
  drag(0.05);
  nudge(0.051);
  EXPECT_EQ(goal_after_undo(), 0.05);
  EXPECT_EQ(goal_after_undo(), 0.003);
  EXPECT_EQ(goal_after_undo(), 0.001);
  EXPECT_EQ(now_.settings.stiffnesses.k_r, 777.0);
  EXPECT_EQ(goal_after_undo(), 0.001);
  EXPECT_EQ(goal_after_undo(), 0.0);
  EXPECT_FALSE(has_more());
}

TEST_F(UndoTest, AKeyPressAfterUndoIsAStepOfItsOwn) {
  nudge(0.001);
  set_stiffness(777.0);
  EXPECT_EQ(goal_after_undo(), 0.001);
  nudge(0.002);
  EXPECT_EQ(history_.after(), nullptr);
  EXPECT_EQ(goal_after_undo(), 0.001);
  EXPECT_EQ(goal_after_undo(), 0.0);
}

TEST_F(UndoTest, WhatAnInputDoesWithTheGoalIsNoStep) {
  now_.goal_is_chosen = false;
  nudge(0.02);
  nudge(0.03);
  now_.goal_is_chosen = true;  // back at the mouse, whose goal is where it was left
  nudge(0.04);
  EXPECT_FALSE(has_more());
  nudge(0.05);
  EXPECT_EQ(goal_after_undo(), 0.04);
}

}  // namespace
}  // namespace ghostforce::undo_test
