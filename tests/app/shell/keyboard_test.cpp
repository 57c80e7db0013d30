// Key presses in the offscreen window: each acts by itself, however slow the frames are; and the control that Tab leads
// to owns arrows and Enter, but never Space.
#include "app/shell/keyboard.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <imgui_internal.h>

#include "app/widgets/focus.h"
#include "tests/app/shell/driven_window.h"

namespace ghostforce::keyboard_test {
namespace {

struct Press {
  int key;
  int modifiers = 0;
};
constexpr int ctrl = modifier::control;
constexpr int shift = modifier::shift;

class KeyboardTest : public DrivenWindow {
 protected:
  void send(const Press& press) {
    send_key(press.key, GLFW_PRESS, press.modifiers);
    const bool types = press.modifiers == 0 && press.key >= key::digit_0 && press.key <= key::z;
    if (types) send_character(static_cast<unsigned int>(press.key));
    send_key(press.key, GLFW_RELEASE, 0);
  }
  // All of them before one frame, and then as many frames as they need.
  void send_at_once(const std::vector<Press>& presses) {
    for (const Press& press : presses) send(press);
    frames(6 * static_cast<int>(presses.size()) + 4, 0);
  }
  void send_one_by_one(const std::vector<Press>& presses) {
    for (const Press& press : presses) {
      send(press);
      frames(6, 0);
    }
    frames(4, 0);
  }
  static ImGuiID focused() { return has_focus() ? ImGui::GetCurrentContext()->NavId : 0; }
  static ImGuiID in_column(const char* id, const char* table) {
    return ImHashStr(id, 0, ImGui::FindWindowByName("panels")->GetID(table));
  }
  // All that Tab leads to, until it is where it was.
  std::vector<ImGuiID> tab_stops() {
    std::vector<ImGuiID> stops;
    std::set<ImGuiID> seen;
    for (int i = 0; i < 100; ++i) {
      press(key::tab);
      if (!seen.insert(focused()).second) break;
      stops.push_back(focused());
    }
    return stops;
  }
  // Until the focus is there.
  bool tab_to(ImGuiID wanted) {
    for (int i = 0; i < 100 && focused() != wanted; ++i) press(key::tab);
    return focused() == wanted;
  }
};

struct Sequence {
  const char* name;
  std::vector<Press> presses;
};

TEST_F(KeyboardTest, ManyPressesBeforeASlowFrameDoWhatEachBeforeItsOwnDoes) {
  const std::vector<Press> changes{{key::minus}, {key::left_bracket}, {key::left_bracket},
                                   {key::equal}, {key::equal},        {key::left_bracket}};
  const auto after_changes = [&](std::vector<Press> more) {
    more.insert(more.begin(), changes.begin(), changes.end());
    return more;
  };
  const std::vector<Sequence> sequences{
      {"undo twice", after_changes({{key::z, ctrl}, {key::z, ctrl}})},
      {"undo, undo, redo", after_changes({{key::z, ctrl}, {key::z, ctrl}, {key::z, ctrl | shift}})},
      {"undo, change, undo, undo, redo",
       after_changes({{key::z, ctrl}, {key::minus}, {key::z, ctrl}, {key::z, ctrl}, {key::y, ctrl}})},
      {"full screen three times", {{key::f11}, {key::f11}, {key::f11}}},
      {"help three times", {{key::f1}, {key::f1}, {key::f1}}},
      {"plots and pause", {{key::f3}, {key::space}, {key::f3}, {key::f3}, {key::space}}},
      {"a step on and three back", {{key::period}, {key::comma}, {key::comma}, {key::comma}}},
      {"a scene by its name, and a key after it",
       {{key::o, ctrl}, {key::f}, {key::i}, {key::g}, {key::digit_1}, {key::enter}, {key::digit_3}}},
      {"the talk", {{key::page_down}, {key::page_down}, {key::page_down}, {key::enter}}},
      {"a guess, its answer, and a new one", {{key::q}, {key::enter}, {key::enter}, {key::enter}}},
      {"a goal to and fro", {{key::right}, {key::right, ctrl}, {key::up, shift}, {key::left}, {key::down, ctrl}}},
      {"a focused control, and the goal afterwards",
       {{key::tab}, {key::tab}, {key::enter}, {key::escape}, {key::right}}},
  };
  for (const Sequence& sequence : sequences) {
    SCOPED_TRACE(sequence.name);
    struct End {
      Settings settings;
      std::string title;
      Vector<2> goal;
      Dialog dialog;
      Face face;
      StageMode mode;
      int why_step;
      bool paused, has_plots, is_full_screen;
      std::int64_t tick;
      std::optional<double> looks_back_to_s;
      std::uint32_t offs;
    };
    const auto end_after = [&](bool at_once) {
      open({});
      frames(20);
      if (window_->is_full_screen()) window_->toggle_full_screen();
      at_once ? send_at_once(sequence.presses) : send_one_by_one(sequence.presses);
      const Session& s = session();
      return End{s.settings,   s.scene->title,          s.goal,      s.dialog,        s.face,
                 s.stage.mode, s.stage.why_step,        s.paused,    s.plots.is_open, window_->is_full_screen(),
                 now().tick,   s.stage.looks_back_to_s, s.offs_asked};
    };
    const End one_by_one = end_after(false);
    const End at_once = end_after(true);
    EXPECT_EQ(at_once.settings, one_by_one.settings);
    EXPECT_EQ(at_once.title, one_by_one.title);
    EXPECT_EQ(at_once.goal, one_by_one.goal);
    EXPECT_EQ(at_once.dialog, one_by_one.dialog);
    EXPECT_EQ(at_once.face, one_by_one.face);
    EXPECT_EQ(at_once.mode, one_by_one.mode);
    EXPECT_EQ(at_once.why_step, one_by_one.why_step);
    EXPECT_EQ(at_once.paused, one_by_one.paused);
    EXPECT_EQ(at_once.has_plots, one_by_one.has_plots);
    EXPECT_EQ(at_once.is_full_screen, one_by_one.is_full_screen);
    EXPECT_EQ(at_once.tick, one_by_one.tick);
    EXPECT_EQ(at_once.looks_back_to_s, one_by_one.looks_back_to_s);
    EXPECT_GE(at_once.offs, one_by_one.offs);
    if (window_->is_full_screen()) window_->toggle_full_screen();
  }
}

TEST_F(KeyboardTest, TwoQuickUndosUndoTwice) {
  const Settings first = session().settings;
  press(key::left_bracket);
  press(key::left_bracket);
  ASSERT_NE(session().settings, first);
  send({key::z, ctrl});
  send({key::z, ctrl});
  frames(1);
  EXPECT_EQ(session().settings, first) << "in one frame";
}

TEST_F(KeyboardTest, EscapeTurnsMotorsOffHoweverMuchWaitsBeforeIt) {
  open({.input = "virtual-falcon"});
  const std::uint32_t before = session().offs_asked;
  for (int i = 0; i < 10; ++i) send({key::tab});
  send({key::escape});
  frames(1);
  EXPECT_GT(session().offs_asked, before);
}

TEST_F(KeyboardTest, TabGoesThroughBarsPanelsAndPlotsAndBack) {
  session().folded_panels = {};
  session().plots.is_open = true;
  frames(3);
  const std::vector<ImGuiID> stops = tab_stops();
  const std::set<ImGuiID> all(stops.begin(), stops.end());
  EXPECT_GT(stops.size(), 40U);
  for (const char* window : {"strategies", "panels", "plots", "status"}) {
    ASSERT_NE(ImGui::FindWindowByName(window), nullptr) << window;
  }
  const auto has = [&](const char* window, const char* id) {
    return all.contains(ImGui::FindWindowByName(window)->GetID(id));
  };
  EXPECT_TRUE(has("strategies", "##pause"));
  EXPECT_TRUE(has("panels", "Rendering")) << "the head of a panel";
  EXPECT_TRUE(has("plots", "Save…"));
  EXPECT_FALSE(has("scene", "scene")) << "its keys are the table's";
  press(key::tab, shift);
  press(key::tab, shift);
  EXPECT_NE(focused(), stops.front());
  press(key::tab);
  press(key::tab);
  EXPECT_EQ(focused(), stops.front());
}

TEST_F(KeyboardTest, EnterDoesWhatAClickDoes) {
  const auto enter = [&](const char* window, const char* id) {
    ASSERT_TRUE(tab_to(ImGui::FindWindowByName(window)->GetID(id))) << id;
    press(key::enter);
  };
  enter("panels", "Rendering");
  EXPECT_TRUE(session().folded_panels.contains("Rendering"));
  enter("panels", "Rendering");
  EXPECT_FALSE(session().folded_panels.contains("Rendering"));
  enter("strategies", "##compare");
  press(key::down);
  press(key::enter);
  EXPECT_EQ(session().options.compare, Compare::side_by_side) << "chosen in a menu";
  press(key::f3);
  enter("plots", "Wall angle");
  EXPECT_EQ(session().plots.tab, PlotTab::wall_angle);
}

TEST_F(KeyboardTest, TheStagesButtonsAndDialogsAreReachedToo) {
  session().face = Face::stage;
  frames(3);
  const std::vector<ImGuiID> stops = tab_stops();
  EXPECT_GE(stops.size(), 7U) << "three strategies and the four buttons above";
  press(key::escape);
  EXPECT_FALSE(has_focus());
  press(key::s, ctrl);
  ASSERT_EQ(session().dialog, Dialog::save_scene);
  EXPECT_GE(tab_stops().size(), 3U) << "the path, Save and Cancel";
  press(key::escape);
  EXPECT_EQ(session().dialog, Dialog::none);
  EXPECT_FALSE(has_focus()) << "as it was before";
}

TEST_F(KeyboardTest, AFocusedSliderOwnsArrowsAndEnterButNeverSpace) {
  const ImGuiID k_r = in_column("##k_r", "rendering");
  ASSERT_TRUE(tab_to(k_r));
  const Vector<2> goal = session().goal;
  double& value = session().settings.stiffnesses.k_r;
  double before = value;
  const auto ratio_after = [&](int key, int modifiers) {
    before = value;
    press(key, modifiers);
    return value / before;
  };
  // A hundredth of a slider from 1 to 20000, which is logarithmic; 2 %: three digits.
  EXPECT_NEAR(ratio_after(key::right, 0), std::pow(20000.0, 0.01), 0.02);
  EXPECT_NEAR(ratio_after(key::down, 0), std::pow(20000.0, -0.01), 0.02);
  EXPECT_NEAR(ratio_after(key::up, shift), std::pow(20000.0, 0.001), 0.005);
  EXPECT_NEAR(ratio_after(key::left, modifier::alt), std::pow(20000.0, -0.001), 0.005);
  EXPECT_NEAR(ratio_after(key::right, ctrl), std::pow(20000.0, 0.1), 0.05);
  press(key::home);
  EXPECT_EQ(value, 1.0);
  press(key::end);
  EXPECT_EQ(value, 20000.0);
  press(key::enter);
  type("750");
  EXPECT_FALSE(session().paused);
  press(key::enter);
  EXPECT_EQ(value, 750.0);
  EXPECT_EQ(session().goal, goal);
  EXPECT_FALSE(session().paused);
  press(key::space);
  EXPECT_TRUE(session().paused);
  EXPECT_EQ(value, 750.0);
  const std::uint32_t offs = session().offs_asked;
  ASSERT_TRUE(tab_to(k_r));
  press(key::escape);
  EXPECT_EQ(session().offs_asked, offs + 1);
  EXPECT_FALSE(has_focus());
  press(key::right);
  EXPECT_NE(session().goal, goal) << "without a focus arrows move the goal";
  EXPECT_EQ(value, 750.0);
}

TEST_F(KeyboardTest, AnAngleTurnsOnBeyondHalfATurnAndShowsARealMinus) {
  session().folded_panels = {};
  frames(3);
  constexpr double degree = 3.14159265358979323846 / 180.0;
  ASSERT_TRUE(tab_to(in_column("##normal", "wall")));
  double& angle = session().settings.wall_normal_angle;
  angle = 179.5 * degree;
  press(key::right);
  EXPECT_NEAR(angle, 180.0 * degree, 1e-9);
  press(key::right);
  EXPECT_NEAR(angle, -179.0 * degree, 1e-9);
  press(key::right, shift);
  EXPECT_NEAR(angle, -178.9 * degree, 1e-9);
  EXPECT_TRUE(says("−178.9°"));
  EXPECT_FALSE(says("-178.9°"));
  press(key::left, ctrl);
  EXPECT_NEAR(std::abs(angle), 180.0 * degree, 1e-9);
}

TEST_F(KeyboardTest, TheTimeInSightOfThePlotsIsChosenWithoutAMouse) {
  press(key::f3);
  frames(3);
  const PlotView& plots = session().plots;
  ASSERT_DOUBLE_EQ(plots.span_s(), 4.0);
  ASSERT_TRUE(tab_to(ImGui::FindWindowByName("plots")->GetID("##span")));
  press(key::enter);
  press(key::down);
  press(key::enter);
  EXPECT_NEAR(plots.span_s(), 10.0, 1e-9);
  EXPECT_TRUE(says("10 s"));
}

TEST_F(KeyboardTest, KeysScrollAnOpenDialog) {
  session().appearance.scale = 2.0;
  frames(3);
  const Vector<2> goal = session().goal;
  press(key::f1);
  frames(3);
  const ImGuiWindow& help = *ImGui::FindWindowByName("###help");
  ASSERT_GT(help.ScrollMax.y, 0.0F);
  const auto expect_scrolled = [&](int key, float least, float most) {
    const float before = help.Scroll.y;
    press(key);
    EXPECT_GT(help.Scroll.y - before, least) << key;
    EXPECT_LT(help.Scroll.y - before, most) << key;
  };
  const float page = help.InnerRect.GetHeight();
  expect_scrolled(key::down, 20.0F, 0.5F * page);
  expect_scrolled(key::up, -0.5F * page, -20.0F);
  expect_scrolled(key::page_down, 0.7F * page, page);
  expect_scrolled(key::page_up, -page, -0.7F * page);
  send_at_once({{key::down}, {key::down}, {key::up}, {key::down}});
  const float two_lines = help.Scroll.y;
  press(key::home);
  EXPECT_EQ(help.Scroll.y, 0.0F);
  send_one_by_one({{key::down}, {key::down}});
  EXPECT_EQ(help.Scroll.y, two_lines);
  press(key::end);
  EXPECT_EQ(help.Scroll.y, help.ScrollMax.y);
  press(key::right);
  EXPECT_EQ(session().goal, goal) << "none of these is the goal's";
  EXPECT_EQ(session().face, Face::workbench) << "nor a step of the talk";
  EXPECT_FALSE(session().stage.demo_step);
}

TEST_F(KeyboardTest, PagesScrollTheScenesThoughTheirFieldHasTheKeyboard) {
  session().appearance.scale = 2.0;
  frames(3);
  press(key::o, ctrl);
  frames(3);
  const auto scrolled = [] {
    float most = 0.0F;
    for (const ImGuiWindow* window : ImGui::FindWindowByName("Open a scene")->DC.ChildWindows) {
      most = std::max(most, window->Scroll.y);
    }
    return std::max(most, ImGui::FindWindowByName("Open a scene")->Scroll.y);
  };
  const float before = scrolled();
  ASSERT_GT(before, 50.0F) << "the scene that is open is the last one";
  press(key::page_up);
  const float page_before = scrolled();
  EXPECT_LT(page_before, before - 50.0F);
  press(key::page_up);
  press(key::page_down);
  EXPECT_EQ(scrolled(), page_before);
}

TEST_F(KeyboardTest, TheDialSaysWhomItActsOnWhileItIsTurned) {
  const auto says_so = [] { return says("Only Anisotropic"); };
  press(key::digit_2);
  EXPECT_FALSE(says_so());
  press(key::equal);
  EXPECT_TRUE(says_so());
  press(key::digit_3);
  EXPECT_FALSE(says_so());
  press(key::digit_1);
  frames(300, 0);
  EXPECT_FALSE(says_so());
  ASSERT_TRUE(tab_to(in_column("ratio", "rendering")));
  frames(2, 0);
  EXPECT_TRUE(says_so());
}

TEST_F(KeyboardTest, TheDialIsTurnedAndTypedInto) {
  ASSERT_TRUE(tab_to(in_column("ratio", "rendering")));
  Stiffnesses& stiffnesses = session().settings.stiffnesses;
  ASSERT_FALSE(stiffnesses.chosen_tracking_ratio);
  press(key::left);
  ASSERT_TRUE(stiffnesses.chosen_tracking_ratio) << "it leaves the optimum";
  press(key::right);
  EXPECT_FALSE(stiffnesses.chosen_tracking_ratio) << "and finds it again";
  press(key::enter);
  type("2.5");
  press(key::enter);
  EXPECT_EQ(stiffnesses.chosen_tracking_ratio, 2.5);
}

TEST_F(KeyboardTest, KeysMoveThePicture) {
  const SceneView before = session().shown;
  press(key::z);
  EXPECT_LT(session().shown.width, before.width);
  press(key::z, shift);
  EXPECT_NEAR(session().shown.width, before.width, 1e-12);
  const Vector<2> goal = session().goal;
  press(key::right, modifier::alt);
  EXPECT_LT(session().shown.center.x, before.center.x);
  EXPECT_EQ(session().goal, goal);
}

TEST_F(KeyboardTest, KeysMoveAllPanesSideBySide) {
  session().options.compare = Compare::side_by_side;
  frames(2);
  ASSERT_TRUE(session().pane_views);
  const PaneViews before = *session().pane_views;
  const SceneView shown = session().shown;
  press(key::z);
  ASSERT_TRUE(session().pane_views);
  EXPECT_LT(session().pane_views->width, before.width);
  press(key::right, modifier::alt);
  ASSERT_TRUE(session().pane_views);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    EXPECT_LT(session().pane_views->centers[i].x, before.centers[i].x);
  }
  EXPECT_EQ(session().shown, shown) << "what is not seen stays";
}

TEST_F(KeyboardTest, WhatIsTypedNeverActsAsAKey) {
  send({key::o, ctrl});
  for (const int key : {key::o, key::digit_3, key::r, key::b}) send({key});
  frames(20);
  EXPECT_EQ(session().form.path.size(), 4U);
  EXPECT_EQ(session().settings, load_scene("wall45").settings);
}

}  // namespace
}  // namespace ghostforce::keyboard_test
