// The keys of the stage: its face, its modes, the switch in slow motion and the talk with a clicker.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include <glad/gl.h>
#include <imgui_internal.h>
#include <glm/geometric.hpp>

#include "app/picture/handles.h"
#include "app/state/apply.h"
#include "app/state/mode_changes.h"
#include "app/state/talk.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::stage_keys_test {
namespace {

struct ModeKey {
  int key;
  StageMode mode;
};
constexpr std::array mode_keys{ModeKey{key::q, StageMode::predict},   ModeKey{key::y, StageMode::why},
                               ModeKey{key::l, StageMode::landscape}, ModeKey{key::o, StageMode::round},
                               ModeKey{key::h, StageMode::ribbon},    ModeKey{key::s, StageMode::measure}};

class StageKeysTest : public DrivenWindow {
 protected:
  StageKeysTest() { open({.face = Face::stage}); }
};

TEST_F(StageKeysTest, F4GoesToTheWorkbenchAndBackWhateverIsTyped) {
  press(key::f4);
  EXPECT_EQ(session().face, Face::workbench);
  press(key::o, modifier::control);
  frames(2);
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  press(key::f4);
  EXPECT_EQ(session().face, Face::stage);
}

TEST_F(StageKeysTest, AKeyBeginsItsModeAndEndsItAndTakesOverFromAnother) {
  ASSERT_EQ(mode_keys.size(), stage_mode_catalog().size());
  for (const ModeKey& each : mode_keys) {
    press(each.key);
    EXPECT_EQ(session().stage.mode, each.mode);
    press(each.key);
    EXPECT_EQ(session().stage.mode, StageMode::none) << stage_mode_name(each.mode);
    press(each.key == key::q ? key::l : key::q);
    press(each.key);
    EXPECT_EQ(session().stage.mode, each.mode);
    press(key::escape);
    EXPECT_EQ(session().stage.mode, StageMode::none) << stage_mode_name(each.mode);
  }
}

TEST_F(StageKeysTest, AModesKeyOpensTheStageAndTheWorkbenchEndsIt) {
  for (const ModeKey& each : mode_keys) {
    apply(session(), ShowFace{Face::workbench});
    press(each.key);
    EXPECT_EQ(session().face, Face::stage);
    EXPECT_EQ(session().stage.mode, each.mode);
    press(key::f4);
    EXPECT_EQ(session().face, Face::workbench);
    EXPECT_EQ(session().stage.mode, StageMode::none);
  }
}

TEST_F(StageKeysTest, TheGuideNamesEachMode) {
  const std::string page = read_whole(source_path("/docs/stage.md"));
  for (const StageModeEntry& each : stage_mode_catalog()) {
    EXPECT_NE(page.find("\n**" + std::string(each.key) + ", "), std::string::npos) << each.name;
  }
}

// The circle is the hand's while the mode lasts.
TEST_F(StageKeysTest, RoundAndRoundGivesTheHandBack) {
  press(key::o);
  EXPECT_EQ(session().input, "circle");
  press(key::o);
  EXPECT_EQ(session().input, "mouse");
}

TEST_F(StageKeysTest, AModeCanBeOnFromTheBeginning) {
  for (const ModeKey& each : mode_keys) {
    open({.face = Face::stage, .mode = each.mode});
    EXPECT_EQ(session().stage.mode, each.mode);
    EXPECT_EQ(session().input, each.mode == StageMode::round ? "circle" : "mouse");
    const Image with_mode = picture();
    press(each.key);
    EXPECT_EQ(session().stage.mode, StageMode::none);
    EXPECT_NE(picture(), with_mode);
  }
}

TEST_F(StageKeysTest, EnterIsTheNextStepOfWhyUpToTheLast) {
  press(key::y);
  for (int step = 1; step <= last_why_step; ++step) {
    EXPECT_EQ(session().stage.why_step, step);
    press(step % 2 == 0 ? key::enter : key::number_pad_enter);
  }
  EXPECT_EQ(session().stage.why_step, last_why_step);
}

TEST_F(StageKeysTest, ArrowsMoveAGuessWhileItIsOpenAndThenTheGoalAgain) {
  const Vector<2> goal = session().goal;
  press(key::q);
  ASSERT_TRUE(session().stage.guess);
  const Vector<2> first = *session().stage.guess;
  const auto has_moved_by = [&](double x_mm, double y_mm) {
    return glm::distance(*session().stage.guess, first + 0.001 * Vector<2>(x_mm, y_mm)) < 1e-12;
  };
  press(key::right);
  EXPECT_TRUE(has_moved_by(1.0, 0.0));
  press(key::up, modifier::shift);
  EXPECT_TRUE(has_moved_by(1.0, 0.1));
  press(key::left, modifier::control);
  EXPECT_TRUE(has_moved_by(-9.0, 0.1));
  EXPECT_EQ(session().goal, goal);
  press(key::enter);
  EXPECT_FALSE(session().stage.guess_is_open);
  press(key::down);
  EXPECT_NEAR(session().goal.y, goal.y - 0.001, 1e-12);
  EXPECT_TRUE(has_moved_by(-9.0, 0.1)) << "a new question begins with the guess as it was";
  EXPECT_TRUE(session().stage.guess_is_open);
  press(key::q);
  press(key::down);
  EXPECT_NEAR(session().goal.y, goal.y - 0.002, 1e-12);
}

TEST_F(StageKeysTest, ShiftSwitchesSlowly) {
  for (const auto& [key, id] :
       {std::pair{key::digit_1, StrategyId::full}, std::pair{key::digit_3, StrategyId::anisotropic},
        std::pair{key::digit_2, StrategyId::naive}}) {
    press(key, modifier::shift);
    EXPECT_EQ(session().settings.active, id);
    EXPECT_TRUE(session().stage.switches_slowly);
    press(key);
    EXPECT_FALSE(session().stage.switches_slowly);
  }
}

// Where the handle is drawn, slowly and at once, two seconds after the key.
TEST_F(StageKeysTest, SlowMotionIsSeen) {
  glEnable(GL_RASTERIZER_DISCARD);  // the marks are looked at, and no pixel
  const auto handle_after = [&](int modifiers) {
    press(key::digit_2);
    frames(60);
    press(key::digit_3, modifiers);
    frames(120);
    for (const Mark& mark : screen().panes().front().marks) {
      const auto* const marker = std::get_if<Marker>(&mark.form);
      if (mark.role == Role::device && marker != nullptr) return marker->center;
    }
    return Vector<2>(0.0);
  };
  const Vector<2> rest = now().strategies[index_of(StrategyId::anisotropic)].device;
  EXPECT_LT(glm::distance(handle_after(0), rest), 1e-5);
  EXPECT_GT(glm::distance(handle_after(modifier::shift), rest), 1e-3);
}

TEST_F(StageKeysTest, AClickerGoesThroughTheTalkAndBack) {
  struct Step {
    StrategyId active;
    StageMode mode;
    int why_step;
  };
  constexpr std::array steps{
      Step{StrategyId::full, StageMode::none, 0},        Step{StrategyId::naive, StageMode::none, 0},
      Step{StrategyId::naive, StageMode::why, 1},        Step{StrategyId::naive, StageMode::why, 2},
      Step{StrategyId::naive, StageMode::why, 3},        Step{StrategyId::naive, StageMode::why, 4},
      Step{StrategyId::anisotropic, StageMode::none, 0}, Step{StrategyId::naive, StageMode::landscape, 0},
      Step{StrategyId::anisotropic, StageMode::round, 0}};
  ASSERT_EQ(steps.size(), talk_length());
  const auto expect_step = [&](std::size_t i) {
    EXPECT_EQ(session().face, Face::stage);
    EXPECT_EQ(session().stage.mode, steps[i].mode) << i;
    EXPECT_EQ(session().stage.why_step, steps[i].why_step) << i;
    EXPECT_EQ(session().settings.active, steps[i].active) << i;
    EXPECT_FALSE(session().stage.landscape_dial) << i;
  };
  press(key::page_up);
  EXPECT_FALSE(session().stage.demo_step) << "nothing is before the first";
  apply(session(), ShowFace{Face::workbench});
  for (std::size_t i = 0; i < steps.size(); ++i) {
    press(key::page_down);
    expect_step(i);
    if (i + 1 == steps.size()) break;
    // Whatever is tried meanwhile, the next step is as it should be.
    press(i % 2 == 0 ? key::digit_1 : key::digit_3);
    if (session().stage.mode == StageMode::landscape) act(TurnLandscapeDial{1.0});
  }
  press(key::page_down);
  expect_step(steps.size() - 1);
  for (std::size_t i = steps.size() - 1; i-- > 0;) {
    press(key::page_up);
    expect_step(i);
  }
  press(key::page_up);
  expect_step(0);
}

// A press, a drag and its end that come between two frames turn the motor as slow ones do, and move nothing else.
TEST_F(StageKeysTest, AQuickDragOfTheRailsEndTurnsTheMotor) {
  for (const Face face : {Face::stage, Face::workbench}) {
    open({.face = face});
    const Settings before = session().settings;
    const Vector<2> goal = session().goal;
    Vector<2> end;
    if (face == Face::stage) {
      ASSERT_TRUE(screen().stage().picture().motor_grips);
      end = in_window((*screen().stage().picture().motor_grips)[0]);
    } else {
      const MotorDial dial = motor_dial(screen().panes()[0].camera, 1.0);
      end = in_window(dial.middle + Vector<2>(dial.radius - 6.0, 0.0));
    }
    point_at(end);
    button(GLFW_PRESS);
    point_at(end + Vector<2>(0.0, -40.0));
    button(GLFW_RELEASE);
    frames(8);
    EXPECT_NE(session().settings.actuated_angle, before.actuated_angle) << face_name(face);
    EXPECT_EQ(session().settings.wall_normal_angle, before.wall_normal_angle);
    EXPECT_EQ(session().goal, goal) << face_name(face);
  }
}

TEST_F(StageKeysTest, TheMenuOpensWhatHasNoButtonOfItsOwn) {
  const auto is_open = [&] { return screen().stage().picture().menu.has_value(); };
  click_on(StageCommand::menu);
  ASSERT_TRUE(is_open());
  click_on(StageMode::landscape);
  EXPECT_EQ(session().stage.mode, StageMode::landscape);
  EXPECT_FALSE(is_open());
  press(key::escape);
  EXPECT_EQ(session().stage.mode, StageMode::none);
  click_on(StageCommand::menu);
  click_on(StageCommand::palette);
  EXPECT_EQ(session().dialog, Dialog::palette);
  press(key::escape);
  frames(2);
  click_on(StageCommand::menu);
  press(key::escape);
  frames(2);
  EXPECT_FALSE(is_open());
  // A press beside it closes it, and moves nothing.
  click_on(StageCommand::menu);
  const Vector<2> before = session().goal;
  click_at(300.0, 400.0);
  frames(2);
  EXPECT_FALSE(is_open());
  EXPECT_EQ(session().goal, before);
  click_at(300.0, 400.0);
  EXPECT_NE(session().goal, before);
}

TEST_F(StageKeysTest, TheDeviceStatusLeavesSentenceAndButtonsInSight) {
  press(key::f2);
  frames(3);
  const ImGuiWindow* const status = ImGui::FindWindowByName("Device status");
  ASSERT_NE(status, nullptr);
  for (const StageButton& button : screen().stage().picture().buttons) {
    const bool is_above = button.box.most.y < 200.0;
    EXPECT_TRUE(!is_above || button.box.most.y <= static_cast<double>(status->Pos.y)) << button.box.most.y;
  }
}

TEST_F(StageKeysTest, AHidesTheNumbersAndShowsThemAgain) {
  const auto numbers = [&] { return application_->stage_reading().numbers; };
  ASSERT_TRUE(numbers().ghost_force);
  const Image before = picture();
  press(key::a);
  EXPECT_FALSE(numbers().ghost_force);
  EXPECT_FALSE(numbers().slide);
  EXPECT_NE(picture(), before);
  ASSERT_TRUE(session().notice) << "which key brings them back";
  press(key::a);
  EXPECT_TRUE(numbers().ghost_force);
  EXPECT_FALSE(session().notice);
}

TEST_F(StageKeysTest, AResetBringsTheHandBackIntoSight) {
  const SceneView before = session().stage_shown;
  session().stage_shown.center += Vector<2>(0.5, 0.5);
  session().goal += Vector<2>(0.5, 0.5);
  frames(3);
  press(key::r, modifier::alt);
  frames(3);
  EXPECT_LT(glm::distance(session().stage_shown.center, before.center), 0.01);
}

TEST_F(StageKeysTest, BHidesThePictureAndEscapeShowsItToo) {
  const auto is_black = [&] {
    const Image image = picture();
    return std::ranges::all_of(image.rgb, [](std::uint8_t value) { return value == 0; });
  };
  for (const int shows_again : {key::b, key::escape}) {
    EXPECT_FALSE(is_black());
    press(key::b);
    EXPECT_TRUE(is_black());
    press(shows_again);
  }
  EXPECT_FALSE(is_black());
}

}  // namespace
}  // namespace ghostforce::stage_keys_test
