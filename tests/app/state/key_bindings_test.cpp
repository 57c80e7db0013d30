// Every key of the table, pressed in the offscreen window: it changes something that a person sees, and the right
// thing.
#include "app/state/key_bindings.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <string_view>

#include "app/state/apply.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::key_bindings_test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

class KeysTest : public DrivenWindow {};

TEST_F(KeysTest, NoTwoBindingsHaveTheSameChordAndEveryRowSaysWhatItDoes) {
  for (const KeyBinding& a : key_table()) {
    for (const KeyBinding& b : key_table()) {
      EXPECT_TRUE(&a == &b || a.key != b.key || a.modifiers != b.modifiers) << a.shown << b.shown;
    }
    EXPECT_EQ(a.shown.empty(), a.sentence.empty());
  }
  EXPECT_FALSE(key_table().front().shown.empty());
}

TEST(KeyTable, EveryGroupHasItsRowsTogetherAndTheMouseHasItsPlaceAmongThem) {
  std::set<std::string_view> groups;
  for (const KeyBinding& binding : key_table()) {
    if (!binding.group.empty()) {
      EXPECT_TRUE(groups.insert(binding.group).second) << binding.group;
    }
  }
  EXPECT_FALSE(key_table().front().group.empty());
  for (const MouseGesture& gesture : mouse_table()) EXPECT_TRUE(groups.contains(gesture.group)) << gesture.shown;
}

// What a key needs before it can do something that one sees.
void prepare(const KeyBinding& binding, Session& session) {
  const auto is = [&](int key, int modifiers) { return binding.key == key && binding.modifiers == modifiers; };
  session.paused = true;  // nothing but the key moves the picture
  if (binding.key == key::digit_2) session.settings.active = StrategyId::full;
  if (binding.key == key::enter) apply(session, ToggleMode{StageMode::why});
  if (is(key::page_up, 0)) session.stage.demo_step = 3;
  if (is(key::b, 0) || is(key::a, 0)) apply(session, ShowFace{Face::stage});
  if (is(key::escape, 0)) session.dialog = Dialog::help;
  if (is(key::digit_0, modifier::control)) session.appearance.scale = 1.5;
  if (is(key::r, modifier::alt)) session.settings.stiffnesses.k_r = 900.0;
  if (is(key::f, 0)) session.shown.width = 0.5;
}

TEST(KeyTable, IsTheOneInTheGuide) {
  const std::string guide = read_whole(source_path("/docs/keys.md"));
  std::string table = "| mouse, key | what it does |\n| --- | --- |\n";
  for (const MouseGesture& gesture : mouse_table()) {
    table += fmt::format("| {} | {} |\n", gesture.shown, gesture.sentence);
  }
  for (const KeyBinding& binding : key_table()) {
    if (!binding.shown.empty()) table += fmt::format("| {} | {} |\n", binding.shown, binding.sentence);
  }
  EXPECT_NE(guide.find(table), std::string::npos) << "docs/keys.md should hold\n" << table;
  EXPECT_LE(std::ranges::count(table, '\n'), 2 + 30) << "more than anybody reads";
}

TEST_F(KeysTest, EachKeyChangesThePicture) {
  for (const KeyBinding& binding : key_table()) {
    open({});
    prepare(binding, session());
    frames(4);
    const bool is_undo = binding.key == key::z || binding.key == key::y;
    const bool is_redo = is_undo && (binding.modifiers != modifier::control || binding.key == key::y);
    if (is_undo) press(key::digit_3);
    if (is_redo) press(key::z, modifier::control);
    // The goal moves in model time, and a reset shows after something has moved.
    const bool needs_time = binding.key == key::r || (binding.key >= key::right && binding.key <= key::up);
    if (needs_time) {
      session().goal = {0.03, 0.03};
      session().paused = false;
      frames(20);
      session().paused = binding.key == key::r;
      session().options.trails = false;
      frames(2);
    }
    const Image before = picture();
    press(binding.key, binding.modifiers);
    if (binding.key == key::f11) {
      EXPECT_TRUE(window_->is_full_screen());
      press(key::f11);
    } else if (binding.key == key::q && (binding.modifiers & modifier::control) != 0) {
      EXPECT_TRUE(window_->should_close());
    } else {
      EXPECT_NE(before, picture()) << binding.shown << ' ' << binding.sentence << ' ' << binding.key;
    }
  }
}

TEST_F(KeysTest, HoldingAKeyRepeatsWhatMayBeRepeated) {
  const Vector<2> start = session().goal;
  send_key(key::right, GLFW_PRESS, 0);
  for (int i = 0; i < 4; ++i) send_key(key::right, GLFW_REPEAT, 0);
  frames(2);
  EXPECT_NEAR(session().goal.x - start.x, 0.005, 1e-12);
  send_key(key::space, GLFW_PRESS, 0);
  for (int i = 0; i < 4; ++i) send_key(key::space, GLFW_REPEAT, 0);
  frames(2);
  EXPECT_TRUE(session().paused) << "once";
}

TEST_F(KeysTest, DigitsChooseTheStrategy) {
  for (const auto& [key, id] :
       {std::pair{key::digit_3, StrategyId::anisotropic}, std::pair{key::digit_1, StrategyId::full},
        std::pair{key::digit_2, StrategyId::naive}}) {
    press(key);
    EXPECT_EQ(session().settings.active, id);
  }
}

TEST_F(KeysTest, TheNextWayToCompareIsSeen) {
  EXPECT_EQ(screen().panes().size(), 1U);
  EXPECT_GT(count_marks(Role::device, StrategyId::full), 0);
  act(NextCompareMode{});
  frames(2);
  EXPECT_EQ(session().options.compare, Compare::side_by_side);
  ASSERT_EQ(screen().panes().size(), 3U);
  for (const Pane& pane : screen().panes()) {
    for (const Mark& mark : pane.marks) {
      if (mark.strategy) {
        EXPECT_EQ(*mark.strategy, pane.active);
      }
    }
  }
  act(NextCompareMode{});
  frames(2);
  EXPECT_EQ(session().options.compare, Compare::active_only);
  EXPECT_EQ(count_marks(Role::device, StrategyId::full), 0);
  act(NextCompareMode{});
  frames(2);
  EXPECT_EQ(session().options.compare, Compare::overlay);
}

TEST_F(KeysTest, ArrowsMoveTheGoalByMillimetresTenthsAndCentimetres) {
  const Vector<2> start = now().goal;
  const auto moved = [&] {
    frames(20);
    return (now().goal - start) * 1000.0;
  };
  press(key::right);
  // 1e-9 mm: rounding of metres.
  EXPECT_NEAR(moved().x, 1.0, 1e-9);
  press(key::up);
  EXPECT_NEAR(moved().y, 1.0, 1e-9);
  press(key::left, modifier::shift);
  EXPECT_NEAR(moved().x, 0.9, 1e-9);
  press(key::down, modifier::control);
  EXPECT_NEAR(moved().y, -9.0, 1e-9);
}

TEST_F(KeysTest, ArrowsLeaveAScriptedGoalAlone) {
  open({.input = "script"}, "fig1");
  const Vector<2> before = session().goal;
  press(key::right);
  EXPECT_EQ(session().goal, before);
}

TEST_F(KeysTest, BracketsTurnTheMotorAxisThroughRoundAngles) {
  press(key::left_bracket);
  EXPECT_NEAR(session().settings.actuated_angle, 5.0 * degree, 1e-12);
  press(key::right_bracket);
  press(key::right_bracket);
  EXPECT_NEAR(session().settings.actuated_angle, -5.0 * degree, 1e-12);
  press(key::left_bracket, modifier::shift);
  EXPECT_NEAR(session().settings.actuated_angle, -4.0 * degree, 1e-12);
  press(key::left_bracket);
  EXPECT_NEAR(session().settings.actuated_angle, 0.0, 1e-12) << "to the next whole step";
}

// The drift at rest for a goal at a fixed depth, by the closed form alone.
double naive_drift_at(Settings settings, double theta) {
  settings.wall_normal_angle = settings.actuated_angle - theta;
  const Wall<2> wall = wall_of(settings);
  const Vector<2> goal = wall.point - 0.02 * wall.normal;
  const Equilibrium<2> rest = equilibrium_of(StrategyId::naive, settings, goal);
  const Vector<2> drift = rest.proxy - goal;
  return glm::length(drift - wall.normal * glm::dot(wall.normal, drift));
}

TEST_F(KeysTest, TheWallTurnsToTheLargestNaiveDrift) {
  session().settings.stiffnesses.k_c = std::numeric_limits<double>::infinity();
  const Settings before = session().settings;
  act(TurnWallToLargestDrift{});
  const Settings& after = session().settings;
  const double theta = after.actuated_angle - after.wall_normal_angle;
  EXPECT_LT(std::abs(std::remainder(after.wall_normal_angle - before.wall_normal_angle, 2.0 * std::numbers::pi)),
            45.0 * degree)
      << "the nearest of four";
  const double here = naive_drift_at(after, theta);
  for (const double aside : {-0.01, 0.01}) EXPECT_GT(here, naive_drift_at(after, theta + aside));
}

// By what is typed, on whatever keyboard: 5 % for a plus and a minus, 1 % with Alt, with which nothing is typed.
TEST_F(KeysTest, PlusAndMinusTurnTheRatioByAsMuch) {
  struct Case {
    const char* keyboard;
    int key;
    int modifiers;
    unsigned int character;
    double factor;
  };
  for (const Case& c : {
           Case{"US: Shift+=", key::equal, modifier::shift, '+', 1.05},
           Case{"US: =", key::equal, 0, '=', 1.05},
           Case{"-", key::minus, 0, '-', 1.0 / 1.05},
           Case{"German: +", key::right_bracket, 0, '+', 1.05},
           Case{"Swiss: Shift+1", key::digit_1, modifier::shift, '+', 1.05},
           Case{"number pad: +", key::number_pad_add, 0, '+', 1.05},
           Case{"number pad: -", key::number_pad_subtract, 0, '-', 1.0 / 1.05},
           Case{"US: Alt+Shift+=", key::equal, modifier::alt | modifier::shift, 0, 1.01},
           Case{"Alt+=", key::equal, modifier::alt, 0, 1.01},
           Case{"Alt+-", key::minus, modifier::alt, 0, 1.0 / 1.01},
           Case{"number pad: Alt++", key::number_pad_add, modifier::alt, 0, 1.01},
           Case{"number pad: Alt+-", key::number_pad_subtract, modifier::alt, 0, 1.0 / 1.01},
           Case{"US: Shift+-", key::minus, modifier::shift, '_', 1.0},
       }) {
    session().settings.stiffnesses.chosen_tracking_ratio = 2.0;
    const double motor = session().settings.actuated_angle;
    send_key(c.key, GLFW_PRESS, c.modifiers);
    if (c.character != 0) send_character(c.character);
    send_key(c.key, GLFW_RELEASE, 0);
    frames(2);
    EXPECT_NEAR(session().settings.stiffnesses.chosen_tracking_ratio.value_or(0.0), 2.0 * c.factor, 1e-12)
        << c.keyboard;
    EXPECT_EQ(session().settings.actuated_angle, motor) << c.keyboard;
  }
  // What no key has typed is no press, and a key types once.
  session().settings.stiffnesses.chosen_tracking_ratio = 2.0;
  type("+");
  send_key(key::w, GLFW_RELEASE, 0);
  EXPECT_EQ(session().settings.stiffnesses.chosen_tracking_ratio, 2.0);
}

TEST_F(KeysTest, TheHelpHasRoomForItsLongestLine) {
  for (const auto& [width, height] : {std::pair{1024, 640}, std::pair{1280, 800}}) {
    open({}, "wall45", width, height);
    press(key::f1);
    const ImGuiWindow& help = *ImGui::FindWindowByName("###help");
    EXPECT_LE(help.ContentSizeIdeal.x, help.InnerRect.GetWidth() - 2.0F * help.WindowPadding.x + 0.5F) << width;
    EXPECT_EQ(help.ScrollMax.y, 0.0F);
  }
}

// As the lessons and the palette do.
TEST_F(KeysTest, TheHelpSpeaksTheLanguageOfTheStage) {
  session().language = "es";
  press(key::f1);
  frames(2);
  for (const std::string_view words : {"Mover y cambiar", "Flechas", "Girar el motor 5° (Mayús: 1°)", "Rueda"}) {
    EXPECT_TRUE(says(words)) << words;
  }
  for (const std::string_view words : {"Turn the motor 5°", "Wheel, right drag"}) EXPECT_FALSE(says(words)) << words;
}

TEST_F(KeysTest, DialogsHaveButtonsForFingersOnAPhone) {
  for (const auto& [width, height] : {std::pair{390, 844}, std::pair{844, 390}}) {
    open({}, "wall45", width, height);
    act(OpenDialog{Dialog::lessons});
    frames(4);
    // Its own height is a button's.
    EXPECT_GE(ImGui::FindWindowByName("###lessons")->TitleBarHeight, 44.0F) << width;
  }
}

TEST_F(KeysTest, WhatIsDrawnIsShownAndHidden) {
  struct Case {
    bool ViewOptions::*option;
    Role role;
  };
  for (const Case& c : {Case{&ViewOptions::ghost_forces, Role::ghost_force},
                        Case{&ViewOptions::predictions, Role::prediction}, Case{&ViewOptions::trails, Role::trail}}) {
    const auto toggle = [&] {
      act(ToggleViewOption{c.option});
      frames(2);
    };
    EXPECT_GT(count_marks(c.role), 0) << role_name(c.role);
    toggle();
    EXPECT_EQ(count_marks(c.role), 0) << role_name(c.role);
    toggle();
    EXPECT_GT(count_marks(c.role), 0) << role_name(c.role);
  }
}

TEST_F(KeysTest, ControlQQuitsAndEscapeNever) {
  press(key::escape);
  EXPECT_FALSE(window_->should_close());
  press(key::q, modifier::control);
  EXPECT_TRUE(window_->should_close());
}

TEST_F(KeysTest, F11FillsTheScreenAndComesBack) {
  const WindowSize before = window_->restored_size();
  press(key::f11);
  EXPECT_TRUE(window_->is_full_screen());
  EXPECT_EQ(window_->restored_size().width, before.width);
  press(key::f11);
  EXPECT_FALSE(window_->is_full_screen());
  EXPECT_EQ(window_->restored_size().width, before.width);
  EXPECT_EQ(window_->restored_size().height, before.height);
}

TEST_F(KeysTest, ScaleGoesFrom75To300Percent) {
  for (int i = 0; i < 50; ++i) send_key(key::equal, GLFW_PRESS, modifier::control);
  frames(2);
  EXPECT_EQ(session().appearance.scale, 3.0);
  for (int i = 0; i < 60; ++i) send_key(key::minus, GLFW_PRESS, modifier::control);
  frames(2);
  EXPECT_EQ(session().appearance.scale, 0.75);
  press(key::digit_0, modifier::control);
  EXPECT_EQ(session().appearance.scale, 1.0);
}

}  // namespace
}  // namespace ghostforce::key_bindings_test
