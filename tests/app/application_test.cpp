// The whole program offscreen: the real window, ImGui and OpenGL, driven through the backend's own callbacks as a
// display would drive them, with the servo stepped by hand.
#include "app/application.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui_impl_glfw.h>

#include <memory>

#include "app/keys.h"
#include "app/scene_file.h"

namespace ghostforce {
namespace {

constexpr double frame_s = 1.0 / 60.0;

class ApplicationTest : public testing::Test {
 protected:
  ApplicationTest() { open(Part::window, "mouse"); }

  void open(Part part, std::string_view input) {
    application_.reset();
    window_.reset();
    window_ = std::make_unique<Window>(
        WindowOptions{.title = "test", .width = 1280, .height = 800, .offscreen = true, .takes_mouse = true});
    application_ = std::make_unique<Application>(*window_, ScreenOptions{.part = part, .theme = find_theme("light")},
                                                 load_scene("wall45", {}), *find_input(input));
    ImGui_ImplGlfw_WindowFocusCallback(window_->handle(), GLFW_TRUE);
    ImGui_ImplGlfw_CursorEnterCallback(window_->handle(), GLFW_TRUE);
    point_at(900.0, 795.0);  // nothing there
    frames(3);
  }

  Session& session() { return application_->session(); }
  const Screen& screen() const { return application_->screen(); }

  // A frame of the window and the ticks that the servo makes meanwhile.
  void frames(int count, int ticks_per_frame = 16) {
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < ticks_per_frame; ++k) application_->servo().wake();
      application_->frame(frame_s);
    }
  }

  void point_at(double x, double y) {
    pointer_ = {x, y};
    ImGui_ImplGlfw_CursorPosCallback(window_->handle(), x, y);
  }
  void button(int action) { ImGui_ImplGlfw_MouseButtonCallback(window_->handle(), GLFW_MOUSE_BUTTON_LEFT, action, 0); }
  void click_at(double x, double y) {
    point_at(x, y);
    frames(2);
    button(GLFW_PRESS);
    frames(2);
    button(GLFW_RELEASE);
    frames(2);
  }
  void press(int key) {
    ImGui_ImplGlfw_KeyCallback(window_->handle(), key, 0, GLFW_PRESS, 0);
    frames(2);
    ImGui_ImplGlfw_KeyCallback(window_->handle(), key, 0, GLFW_RELEASE, 0);
    frames(1);
  }
  // The backend asks the platform which modifiers are down, and the null platform has none: told to ImGui itself.
  void press_with_alt(ImGuiKey key) {
    for (const bool down : {true, false}) {
      ImGui::GetIO().AddKeyEvent(ImGuiMod_Alt, down);
      ImGui::GetIO().AddKeyEvent(key, down);
      frames(2);
    }
  }

  Vector<2> on_window(const Vector<2>& world) const {
    const Vector<2> at = to_screen(screen().camera(), world);
    return {at.x + static_cast<double>(screen().scene_corner().x),
            at.y + static_cast<double>(screen().scene_corner().y)};
  }

  std::unique_ptr<Window> window_;
  std::unique_ptr<Application> application_;
  Vector<2> pointer_{0.0};
};

TEST_F(ApplicationTest, StartsAtRestAtTheEndOfTheScenesPath) {
  const Snapshot& now = application_->report().snapshot;
  const Scene scene = load_scene("wall45", {});
  EXPECT_EQ(now.goal, scene.goal.points.back());
  EXPECT_TRUE(now.strategies[index_of(StrategyId::naive)].in_contact);
  EXPECT_GT(glm::length(now.strategies[index_of(StrategyId::naive)].ghost_force), 1.0);
  EXPECT_GT(application_->history().points().size(), 50U) << "the way there is on screen as a trail";
}

TEST_F(ApplicationTest, KeysChooseTheStrategyAndThePictureFollows) {
  Image before = window_->picture();
  for (const auto& [key, id] : {std::pair{GLFW_KEY_3, StrategyId::anisotropic}, std::pair{GLFW_KEY_1, StrategyId::full},
                                std::pair{GLFW_KEY_2, StrategyId::naive}}) {
    press(key);
    EXPECT_EQ(session().settings.active, id);
    const Image after = window_->picture();
    EXPECT_NE(before, after) << strategy(id).name;
    before = after;
  }
}

TEST_F(ApplicationTest, KeyZeroSwitchesTheComparison) {
  press(GLFW_KEY_0);
  EXPECT_EQ(session().compare, Compare::active_only);
  press(GLFW_KEY_0);
  EXPECT_EQ(session().compare, Compare::overlay);
}

TEST_F(ApplicationTest, SpacePausesAndAFullStopSteps) {
  press(GLFW_KEY_SPACE);
  EXPECT_TRUE(session().paused);
  frames(2);
  const std::int64_t paused_at = application_->report().snapshot.tick;
  frames(5);
  EXPECT_EQ(application_->report().snapshot.tick, paused_at);
  press(GLFW_KEY_PERIOD);
  frames(2);
  EXPECT_EQ(application_->report().snapshot.tick, paused_at + 1);
  press(GLFW_KEY_SPACE);
  frames(3);
  EXPECT_GT(application_->report().snapshot.tick, paused_at + 1);
}

TEST_F(ApplicationTest, TheGoalFollowsADragAnywhereInTheScene) {
  const Vector<2> target{0.005, 0.012};
  const Vector<2> there = on_window(target);
  point_at(there.x - 120.0, there.y + 60.0);
  frames(2);
  button(GLFW_PRESS);
  frames(2);
  point_at(there.x, there.y);
  frames(10);
  const Snapshot& now = application_->report().snapshot;
  // ImGui knows the pointer to a whole point.
  const double point = 1.0 / screen().camera().points_per_metre;
  EXPECT_NEAR(now.goal.x, target.x, point);
  EXPECT_NEAR(now.goal.y, target.y, point);
  button(GLFW_RELEASE);
  frames(2);
  point_at(there.x + 50.0, there.y);
  frames(5);
  EXPECT_NEAR(application_->report().snapshot.goal.x, target.x, point) << "let go of";
}

TEST_F(ApplicationTest, ADragOutOfTheSceneLeavesTheGoalAtItsEdge) {
  const Vector<2> inside = on_window({0.0, 0.0});
  point_at(inside.x, inside.y);
  frames(2);
  button(GLFW_PRESS);
  frames(2);
  point_at(5000.0, -300.0);
  frames(10);
  const Vector<2> at = to_screen(screen().camera(), application_->report().snapshot.goal);
  EXPECT_NEAR(at.x, screen().camera().size.x, 1e-3);
  EXPECT_NEAR(at.y, 0.0, 1e-3);
  button(GLFW_RELEASE);
  frames(2);
}

TEST_F(ApplicationTest, ResetStartsTheMotionAgainAndAltResetTheSettingsToo) {
  session().settings.impedances.k_r = 1234.0;
  frames(30);
  const std::int64_t before = application_->report().snapshot.tick;
  press(GLFW_KEY_R);
  EXPECT_LT(application_->report().snapshot.tick, before);
  EXPECT_EQ(session().settings.impedances.k_r, 1234.0);
  press_with_alt(ImGuiKey_R);
  EXPECT_EQ(session().settings, load_scene("wall45", {}).settings);
  EXPECT_EQ(application_->report().snapshot.goal, load_scene("wall45", {}).goal.points.back());
}

TEST_F(ApplicationTest, AChangedSettingReachesTheServo) {
  const double before = glm::length(application_->report().snapshot.strategies[index_of(StrategyId::full)].force);
  session().settings.impedances.k_u *= 2.0;
  frames(200);
  const double after = glm::length(application_->report().snapshot.strategies[index_of(StrategyId::full)].force);
  EXPECT_GT(after, 1.2 * before);
}

TEST_F(ApplicationTest, EveryStrategyButtonWorksUnderThePointer) {
  // The three buttons stand side by side at the left of the top bar.
  click_at(560.0 / 2.0 - 40.0, 22.0);
  EXPECT_EQ(session().settings.active, StrategyId::naive);
  click_at(400.0, 22.0);
  EXPECT_EQ(session().settings.active, StrategyId::anisotropic);
  click_at(90.0, 22.0);
  EXPECT_EQ(session().settings.active, StrategyId::full);
}

TEST_F(ApplicationTest, TheScriptedHandPlaysFromThePathsBeginning) {
  open(Part::window, "script");
  EXPECT_LT(application_->report().snapshot.time_s, 0.2);
  const Vector<2> early = application_->report().snapshot.goal;
  frames(70);
  EXPECT_GT(glm::distance(application_->report().snapshot.goal, early), 0.03);
  const Vector<2> middle = on_window({0.0, 0.0});
  const Vector<2> before = application_->report().snapshot.goal;
  click_at(middle.x, middle.y);
  EXPECT_EQ(application_->report().snapshot.goal, before) << "the pointer does not own this goal";
}

TEST_F(ApplicationTest, AWindowMinimisedToNothingDrawsNothingAndComesBack) {
  const Image before = window_->picture();
  window_->resize(0, 0);
  if (window_->pixel_width() != 0) glfwIconifyWindow(window_->handle());
  frames(5);
  window_->resize(1280, 800);
  frames(5);
  EXPECT_EQ(window_->picture().rgb.size(), before.rgb.size());
}

TEST_F(ApplicationTest, UnstableSettingsAreSaidAndLeftAgain) {
  session().settings.impedances.k_r = 1e6;
  session().settings.mass = 0.001;
  frames(20);
  EXPECT_TRUE(application_->report().diverged);
  press(GLFW_KEY_R);
  frames(20);
  EXPECT_TRUE(application_->report().diverged);
  press_with_alt(ImGuiKey_R);
  frames(5);
  EXPECT_FALSE(application_->report().diverged);
  EXPECT_NEAR(application_->report().snapshot.goal.x, 0.01414, 1e-5);
}

TEST_F(ApplicationTest, EveryKeyOfTheTableIsUnique) {
  for (const KeyBinding& a : key_table()) {
    for (const KeyBinding& b : key_table()) {
      EXPECT_TRUE(&a == &b || a.chord != b.chord) << a.shown;
    }
    EXPECT_FALSE(a.sentence.empty()) << a.shown;
  }
}

}  // namespace
}  // namespace ghostforce
