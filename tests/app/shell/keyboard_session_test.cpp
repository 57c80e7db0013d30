// A whole visit without a mouse: help, a strategy, the goal, a setting by its slider and as a number, panels, plots, a
// scene from its file and to one, undo, the stage and back, and the end.
#include <filesystem>

#include <imgui_internal.h>

#include "app/widgets/focus.h"
#include "tests/app/shell/driven_window.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::keyboard_session_test {
namespace {

class KeyboardSession : public DrivenWindow {
 protected:
  KeyboardSession() { ImGui_ImplGlfw_CursorEnterCallback(window_->handle(), GLFW_FALSE); }

  bool tab_to(ImGuiID wanted) {
    for (int i = 0; i < 100; ++i) {
      if (has_focus() && ImGui::GetCurrentContext()->NavId == wanted) return true;
      press(key::tab);
    }
    return false;
  }
  static ImGuiID in_window(const char* window, const char* id) { return ImGui::FindWindowByName(window)->GetID(id); }
  void write(const std::string& text) {
    type(text);
    press(key::enter);
    frames(4);
  }
};

TEST_F(KeyboardSession, NeedsNoMouse) {
  const TemporaryFolder folder;
  press(key::f1);
  EXPECT_EQ(session().dialog, Dialog::help);
  press(key::escape);
  EXPECT_EQ(session().dialog, Dialog::none);

  press(key::tab);
  ASSERT_TRUE(has_focus()) << "the first strategy";
  press(key::enter);
  EXPECT_EQ(session().settings.active, StrategyId::full);
  press(key::tab);
  press(key::enter);
  EXPECT_EQ(session().settings.active, StrategyId::naive);
  press(key::escape);
  EXPECT_FALSE(has_focus());
  press(key::digit_3);
  EXPECT_EQ(session().settings.active, StrategyId::anisotropic);

  const Vector<2> goal = session().goal;
  press(key::up, modifier::control);
  EXPECT_NEAR(session().goal.y - goal.y, 0.01, 1e-12);

  const double k_r = session().settings.stiffnesses.k_r;
  ASSERT_TRUE(tab_to(ImHashStr("##k_r", 0, in_window("panels", "rendering"))));
  press(key::right);
  EXPECT_GT(session().settings.stiffnesses.k_r, k_r);
  press(key::enter);
  write("900");
  EXPECT_EQ(session().settings.stiffnesses.k_r, 900.0);

  ASSERT_TRUE(tab_to(in_window("panels", "Rendering")));
  press(key::enter);
  EXPECT_TRUE(session().folded_panels.contains("Rendering"));
  press(key::enter);
  EXPECT_FALSE(session().folded_panels.contains("Rendering"));

  ASSERT_TRUE(tab_to(in_window("strategies", "##compare")));
  press(key::enter);
  press(key::down);
  press(key::enter);
  EXPECT_EQ(session().options.compare, Compare::side_by_side) << "chosen in a menu";

  press(key::f3);
  EXPECT_TRUE(session().plots.is_open);
  ASSERT_TRUE(tab_to(in_window("plots", "Wall angle")));
  press(key::enter);
  EXPECT_EQ(session().plots.tab, PlotTab::wall_angle);

  press(key::o, modifier::control);
  write("fig1");
  EXPECT_EQ(session().scene->title, load_scene("fig1").title);
  press(key::left_bracket);
  const Settings turned = session().settings;
  press(key::s, modifier::control);
  frames(3);
  press(key::a, modifier::control);
  write(folder / "mine.toml");
  ASSERT_TRUE(std::filesystem::exists(folder / "mine.toml"));
  EXPECT_EQ(load_scene(folder / "mine.toml").settings.actuated_angle, turned.actuated_angle);
  press(key::z, modifier::control);
  EXPECT_NE(session().settings, turned);
  EXPECT_EQ(session().settings, load_scene("fig1").settings);

  press(key::f4);
  EXPECT_EQ(session().face, Face::stage);
  press(key::tab);
  ASSERT_TRUE(has_focus());
  press(key::enter);
  EXPECT_EQ(session().face, Face::stage);
  press(key::f4);
  EXPECT_EQ(session().face, Face::workbench);
  EXPECT_FALSE(has_focus());
  press(key::q, modifier::control);
  EXPECT_TRUE(window_->should_close());
}

}  // namespace
}  // namespace ghostforce::keyboard_session_test
