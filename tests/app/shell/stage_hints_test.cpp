// Hints on the stage: each where it is done, and only while it is true.
#include <array>
#include <string>
#include <string_view>

#include <glad/gl.h>

#include "app/state/apply.h"
#include "app/state/mode_changes.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::stage_hints_test {
namespace {

constexpr std::string_view drag_words = "drag me: your hand";
constexpr std::string_view cure_words = "press 3: anisotropic";
constexpr std::string_view motor_words = "turn the motor by its ends";

class StageHintsTest : public DrivenWindow {
 protected:
  StageHintsTest() { begin(); }

  void begin(const std::string& input = "mouse", const std::string& scene = "wall45") {
    open({.face = Face::stage, .input = input, .offers_hints = true}, scene);
    glEnable(GL_RASTERIZER_DISCARD);  // the marks are looked at, and no pixel
    frames(3);
  }
  // The only one of the three.
  void expect_only(std::string_view words) {
    for (const std::string_view each : std::array{drag_words, cure_words, motor_words}) {
      EXPECT_EQ(scene_says(each), each == words) << each;
    }
  }
  // The hand, to a place in the world.
  void drag_hand_to(const Vector<2>& goal) {
    drag(on_window(session().goal), on_window(goal));
    frames(120);
  }
  void set_goal(const Vector<2>& goal) {
    session().goal = goal;
    frames(200);
  }
};

TEST_F(StageHintsTest, LeadFromTheHandToTheCureToTheMotor) {
  expect_only(drag_words);
  drag_hand_to(session().goal + Vector<2>(0.002, -0.002));
  EXPECT_EQ(session().hint, 1U);
  expect_only(cure_words);
  press(key::digit_3);
  frames(150);  // the switch, and until words have found their places again
  expect_only(motor_words);
  press(key::left_bracket);
  frames(3);
  expect_only("");
  EXPECT_FALSE(session().hint);
}

TEST_F(StageHintsTest, TheMotorsRailIsTurnedByItsEnds) {
  session().hint = 2;
  frames(60);
  expect_only(motor_words);
  const double before = session().settings.actuated_angle;
  const auto& grips = screen().stage().picture().motor_grips;
  ASSERT_TRUE(grips);
  const Vector<2> end = (*grips)[1];
  drag(end, end + Vector<2>(0.0, 120.0));
  EXPECT_NE(session().settings.actuated_angle, before);
  EXPECT_FALSE(session().hint);
}

// Out of the wall there is nothing to cure, and the hint comes when there is.
TEST_F(StageHintsTest, TheCureWaitsForAGhostForce) {
  drag_hand_to({-0.02, 0.02});
  EXPECT_EQ(session().hint, 1U);
  expect_only("");
  set_goal({0.01, -0.01});
  expect_only(cure_words);
  press(key::digit_1);
  frames(60);
  expect_only("");
  press(key::digit_2);
  frames(60);
  expect_only(cure_words);
}

TEST_F(StageHintsTest, TheCureIsPassedOverWhereThereIsNothingToCure) {
  for (const double angle : {0.0, 1.5707963267948966}) {
    begin();
    session().settings.wall_normal_angle = session().settings.actuated_angle + angle;
    session().hint = 1;
    frames(3);
    EXPECT_EQ(session().hint, 2U) << angle;
    EXPECT_FALSE(scene_says(cure_words)) << angle;
  }
}

TEST_F(StageHintsTest, TwoMotorsHaveNoEndsToTurn) {
  session().hint = 2;
  press(key::digit_1);
  frames(60);
  expect_only("");
  press(key::digit_3);
  frames(60);
  expect_only(motor_words);
}

TEST_F(StageHintsTest, NobodyIsAskedToDragWhatAScriptMoves) {
  begin("script");
  EXPECT_EQ(session().hint, 1U);
  EXPECT_FALSE(scene_says(drag_words));
}

TEST_F(StageHintsTest, AModeHasWordsOfItsOwn) {
  for (const StageModeEntry& each : stage_mode_catalog()) {
    apply(session(), ToggleMode{each.id});
    frames(3);
    expect_only("");
    leave_stage_mode(session());
    frames(3);
  }
}

TEST_F(StageHintsTest, ComeAfterWhatTheStageAsksFor) {
  press(key::space);  // "Press Space to go on."
  frames(60);
  expect_only("");
  press(key::space);
  frames(60);
  expect_only(drag_words);
}

TEST_F(StageHintsTest, EscapeIsEnough) {
  press(key::escape);
  EXPECT_FALSE(session().hint);
  expect_only("");
}

TEST_F(StageHintsTest, AreOfferedToNobodyUnasked) {
  open({.face = Face::stage});
  frames(3);
  expect_only("");
}

}  // namespace
}  // namespace ghostforce::stage_hints_test
