// Every key of the table, pressed in the offscreen window: it changes something that a person sees, and the right
// thing.
#include "app/keys.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "app/view/handles.h"
#include "tests/app/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

class KeysTest : public DrivenWindow {
 protected:
  // Nothing but the key may change the picture: time stands still where it does not move the picture by itself.
  void stand_still() {
    session().paused = true;
    frames(3);
  }
};

TEST_F(KeysTest, NoTwoBindingsHaveTheSameChordAndEveryRowSaysWhatItDoes) {
  for (const KeyBinding& a : key_table()) {
    for (const KeyBinding& b : key_table()) {
      EXPECT_TRUE(&a == &b || a.chord != b.chord) << a.shown << b.shown;
    }
    EXPECT_EQ(a.shown.empty(), a.sentence.empty());
  }
  EXPECT_FALSE(key_table().front().shown.empty());
}

// What a key may need before it can do something.
void prepare(const KeyBinding& binding, Session& session) {
  session.settings.active = binding.chord == ImGuiKey_2 ? StrategyId::full : StrategyId::naive;
  session.dialog = binding.chord == ImGuiKey_Escape ? Dialog::help : Dialog::none;
  if (binding.chord == (ImGuiMod_Ctrl | ImGuiKey_0)) session.look.scale = 1.5;
  if (binding.chord == (ImGuiMod_Alt | ImGuiKey_R)) session.settings.impedances.k_r = 900.0;
  if (binding.chord == ImGuiKey_F) session.shown.width = 0.5;
}

TEST(KeyTable, IsTheOneInTheReadme) {
  const std::string readme = read_whole(GHOSTFORCE_README);
  std::string table = "| mouse, key | what it does |\n| --- | --- |\n";
  for (const MouseGesture& gesture : mouse_table()) table += fmt::format("| {} | {} |\n", gesture.shown, gesture.sentence);
  for (const KeyBinding& binding : key_table()) {
    if (!binding.shown.empty()) table += fmt::format("| {} | {} |\n", binding.shown, binding.sentence);
  }
  EXPECT_NE(readme.find(table), std::string::npos) << "README.md should hold\n" << table;
}

TEST_F(KeysTest, EachKeyChangesThePicture) {
  for (const KeyBinding& binding : key_table()) {
    // These change the window or what comes later; below.
    if (binding.chord == (ImGuiMod_Ctrl | ImGuiKey_Q) || binding.chord == ImGuiKey_F11) continue;
    if (binding.chord == (ImGuiMod_Ctrl | ImGuiKey_Z)) continue;
    if (binding.act == key_table()[0].act && session().settings.active == StrategyId::full) continue;
    open({});
    session().speed = 0.001;  // a key that asks for the next tick gets it, and nothing else moves
    stand_still();
    prepare(binding, session());
    const bool is_redo = binding.sentence.starts_with("Redo") || binding.chord == (ImGuiMod_Ctrl | ImGuiKey_Y);
    if (is_redo) {
      session().settings.actuated_angle = 0.5;
      frames(3);
      press(ImGuiMod_Ctrl | ImGuiKey_Z);
    }
    frames(3);
    const bool moves_the_goal = binding.chord == ImGuiKey_R || binding.sentence.starts_with("Move") ||
                                (binding.shown.empty() && glfw_key(static_cast<ImGuiKey>(
                                                              binding.chord & ~ImGuiMod_Mask_)) >= GLFW_KEY_RIGHT &&
                                 glfw_key(static_cast<ImGuiKey>(binding.chord & ~ImGuiMod_Mask_)) <= GLFW_KEY_UP);
    if (moves_the_goal || binding.chord == ImGuiKey_Space) {
      session().paused = false;
      session().speed = 1.0;
      session().goal = {0.03, 0.03};
      frames(20);
    }
    const Image before = picture();
    press(binding.chord);
    frames(3);
    EXPECT_NE(before, picture()) << binding.shown << ' ' << binding.sentence << ' ' << ImGui::GetKeyName(
        static_cast<ImGuiKey>(binding.chord & ~ImGuiMod_Mask_));
    ASSERT_FALSE(testing::Test::HasFatalFailure());
  }
}

TEST_F(KeysTest, DigitsChooseTheStrategy) {
  for (const auto& [key, id] : {std::pair{ImGuiKey_3, StrategyId::anisotropic}, std::pair{ImGuiKey_1, StrategyId::full},
                                std::pair{ImGuiKey_2, StrategyId::naive}}) {
    press(key);
    EXPECT_EQ(session().settings.active, id);
  }
}

TEST_F(KeysTest, ZeroGoesRoundTheWaysToCompare) {
  EXPECT_EQ(screen().panes().size(), 1U);
  EXPECT_GT(count_marks(Role::device, StrategyId::full), 0);
  press(ImGuiKey_0);
  EXPECT_EQ(session().options.compare, Compare::side_by_side);
  ASSERT_EQ(screen().panes().size(), 3U);
  for (const Pane& pane : screen().panes()) {
    for (const Mark& mark : pane.marks) {
      if (mark.strategy) {
        EXPECT_EQ(*mark.strategy, pane.active);
      }
    }
  }
  press(ImGuiKey_0);
  EXPECT_EQ(session().options.compare, Compare::active_only);
  EXPECT_EQ(count_marks(Role::device, StrategyId::full), 0);
  press(ImGuiKey_0);
  EXPECT_EQ(session().options.compare, Compare::overlay);
}

TEST_F(KeysTest, ArrowsMoveTheGoalByMillimetresTenthsAndCentimetres) {
  const Vector<2> start = now().goal;
  const auto moved = [&] {
    frames(20);
    return (now().goal - start) * 1000.0;
  };
  press(ImGuiKey_RightArrow);
  // 1e-9 mm: rounding of metres.
  EXPECT_NEAR(moved().x, 1.0, 1e-9);
  press(ImGuiKey_UpArrow);
  EXPECT_NEAR(moved().y, 1.0, 1e-9);
  press(ImGuiMod_Shift | ImGuiKey_LeftArrow);
  EXPECT_NEAR(moved().x, 0.9, 1e-9);
  press(ImGuiMod_Ctrl | ImGuiKey_DownArrow);
  EXPECT_NEAR(moved().y, -9.0, 1e-9);
}

TEST_F(KeysTest, ArrowsLeaveAScriptedGoalAlone) {
  open({.input = "script"}, "fig1");
  const Vector<2> before = session().goal;
  press(ImGuiKey_RightArrow);
  EXPECT_EQ(session().goal, before);
}

TEST_F(KeysTest, BracketsTurnTheMotorAxisThroughRoundAngles) {
  press(ImGuiKey_LeftBracket);
  EXPECT_NEAR(session().settings.actuated_angle, 5.0 * degree, 1e-12);
  press(ImGuiKey_RightBracket);
  press(ImGuiKey_RightBracket);
  EXPECT_NEAR(session().settings.actuated_angle, -5.0 * degree, 1e-12);
  press(ImGuiMod_Shift | ImGuiKey_LeftBracket);
  EXPECT_NEAR(session().settings.actuated_angle, -4.0 * degree, 1e-12);
  press(ImGuiKey_LeftBracket);
  EXPECT_NEAR(session().settings.actuated_angle, 0.0, 1e-12) << "to the next whole step";
}

// The drift at rest for a goal at a fixed depth, by the closed form alone.
double naive_drift_at(Settings settings, double theta) {
  settings.wall_normal_angle = settings.actuated_angle - theta;
  const Wall<2> wall = wall_of(settings);
  const Vector<2> goal = wall.point - 0.02 * wall.normal;
  const Equilibrium<2> rest = rest_of(StrategyId::naive, settings, goal);
  const Vector<2> drift = rest.proxy - goal;
  return glm::length(drift - wall.normal * glm::dot(wall.normal, drift));
}

TEST_F(KeysTest, WTurnsTheWallToTheLargestNaiveDrift) {
  session().settings.impedances.k_c = std::numeric_limits<double>::infinity();
  const Settings before = session().settings;
  press(ImGuiKey_W);
  const Settings& after = session().settings;
  const double theta = after.actuated_angle - after.wall_normal_angle;
  EXPECT_LT(std::abs(std::remainder(after.wall_normal_angle - before.wall_normal_angle, 2.0 * std::numbers::pi)),
            45.0 * degree)
      << "the nearest of four";
  const double here = naive_drift_at(after, theta);
  for (const double aside : {-0.01, 0.01}) EXPECT_GT(here, naive_drift_at(after, theta + aside));
}

TEST_F(KeysTest, GPAndTShowAndHide) {
  struct Case {
    ImGuiKey key;
    Role role;
  };
  for (const Case& c : {Case{ImGuiKey_G, Role::ghost_force}, Case{ImGuiKey_P, Role::prediction},
                        Case{ImGuiKey_T, Role::trail}}) {
    EXPECT_GT(count_marks(c.role), 0) << role_name(c.role);
    press(c.key);
    EXPECT_EQ(count_marks(c.role), 0) << role_name(c.role);
    press(c.key);
    EXPECT_GT(count_marks(c.role), 0) << role_name(c.role);
  }
}

TEST_F(KeysTest, ControlQQuitsAndEscapeNever) {
  press(ImGuiKey_Escape);
  EXPECT_FALSE(window_->should_close());
  press(ImGuiMod_Ctrl | ImGuiKey_Q);
  EXPECT_TRUE(window_->should_close());
}

TEST_F(KeysTest, F11FillsTheScreenAndComesBack) {
  const WindowSize before = window_->restored_size();
  press(ImGuiKey_F11);
  EXPECT_TRUE(window_->is_full_screen());
  EXPECT_EQ(window_->restored_size().width, before.width);
  press(ImGuiKey_F11);
  EXPECT_FALSE(window_->is_full_screen());
  EXPECT_EQ(window_->restored_size().width, before.width);
  EXPECT_EQ(window_->restored_size().height, before.height);
}

TEST_F(KeysTest, ScaleGoesFrom75To300Percent) {
  for (int i = 0; i < 50; ++i) press(ImGuiMod_Ctrl | ImGuiKey_Equal);
  EXPECT_EQ(session().look.scale, 3.0);
  for (int i = 0; i < 60; ++i) press(ImGuiMod_Ctrl | ImGuiKey_Minus);
  EXPECT_EQ(session().look.scale, 0.75);
  press(ImGuiMod_Ctrl | ImGuiKey_0);
  EXPECT_EQ(session().look.scale, 1.0);
}

TEST_F(KeysTest, LettersTypedIntoAFieldAreLetters) {
  press(ImGuiMod_Ctrl | ImGuiKey_O);
  frames(2);
  ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  press(ImGuiKey_3);
  press(ImGuiKey_W);
  EXPECT_EQ(session().settings, load_scene("wall45").settings);
  press(ImGuiKey_Escape);
  EXPECT_EQ(session().dialog, Dialog::none);
}

}  // namespace
}  // namespace ghostforce
