// Somebody who presses, drags and types whatever there is, in any order, with every panel open and whoever moves the
// goal: nothing breaks, every value stays one that a scene may have, and no number on screen is none. ImGui's own
// assertions watch too: they end the program.
//
// As many events as GHOSTFORCE_MONKEY_EVENTS says, from the seed GHOSTFORCE_MONKEY_SEED.
#include <array>
#include <cmath>
#include <filesystem>
#include <random>
#include <string_view>
#include <variant>

#include <glad/gl.h>
#include <imgui_internal.h>

#include "app/shell/gestures.h"
#include "app/state/apply.h"
#include "app/state/key_bindings.h"
#include "app/state/scene_as_seen.h"
#include "app/state/scene_view_limits.h"
#include "tests/app/shell/driven_window.h"
#include "tests/app/shell/monkey.h"
#include "tests/device/servo/servo_scenes.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::monkey_test {
namespace {

TEST(NoNumber, IsFoundAmidWords) {
  EXPECT_EQ(no_number_in("force -nan N"), "force -nan");
  EXPECT_EQ(no_number_in("x = inf"), "x = inf");
  EXPECT_EQ(no_number_in("financial information, nano, κinf"), "");
}

class MonkeyTest : public DrivenWindow {
 protected:
  // High enough for every panel at once.
  static constexpr int width = 1280;
  static constexpr int height = 2400;

  MonkeyTest() {
    std::filesystem::current_path(folder_.path());
    ApplicationOptions options;
    options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
    options.inputs = desktop_inputs({.id = {0xFFFF, 0xFFFF}});  // nobody's: no monkey drives a real one
    open(options, "wall45", width, height);
    // All is drawn, and nothing is filled in, which would take most of the time.
    glEnable(GL_RASTERIZER_DISCARD);
    // ImGui can write what it draws to the clipboard, from the beginning of a frame to its end.
    ImGui::GetPlatformIO().Platform_SetClipboardTextFn = [](ImGuiContext*, const char* text) { words_ = text; };
    ImGuiContextHook hook;
    hook.Type = ImGuiContextHookType_NewFramePost;
    hook.Callback = [](ImGuiContext*, ImGuiContextHook*) { ImGui::LogToClipboard(0); };
    ImGui::AddContextHook(ImGui::GetCurrentContext(), &hook);
  }
  ~MonkeyTest() override { std::filesystem::current_path(before_); }

  int any(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  template <typename Choices>
  auto any_of(const Choices& choices) {
    return choices[static_cast<std::size_t>(any(static_cast<int>(std::size(choices))))];
  }
  // Also beside the window; most often on the panels, in the bars or in the scene's upper part.
  Vector<2> anywhere() {
    if (any(2) == 0) return {static_cast<double>(width - any(330)), static_cast<double>(any(height))};
    if (any(3) == 0)
      return {static_cast<double>(any(width)), static_cast<double>(any(2) == 0 ? any(60) : height - any(300))};
    return {static_cast<double>(any(width + 20) - 10), static_cast<double>(any(height + 20) - 10)};
  }
  void frame() { frames(1, any(8) == 0 ? any(100) : any(4)); }
  void press_button(const Vector<2>& at, int which) {
    point_at(at);
    frame();
    button(GLFW_PRESS, which);
    frame();
  }

  void do_something() {
    switch (any(11)) {
      case 0:
      case 1: {
        const KeyBinding binding = any_of(key_table());
        if (binding.key != key::q || (binding.modifiers & modifier::control) == 0) {
          send_key(binding.key, any(4) == 0 ? GLFW_REPEAT : GLFW_PRESS, binding.modifiers);
          send_key(binding.key, GLFW_RELEASE, 0);
        }
        break;
      }
      case 2:
      case 3: {
        const int which = any(4) == 0 ? GLFW_MOUSE_BUTTON_RIGHT : GLFW_MOUSE_BUTTON_LEFT;
        const Vector<2> from = anywhere();
        press_button(from, which);
        point_at(any(2) == 0 ? anywhere() : from + Vector<2>{any(40) - 20, any(40) - 20});
        frame();
        button(GLFW_RELEASE, which);
        break;
      }
      case 4:
      case 5:
      case 6: {
        const bool is_control = any(3) == 0;  // a slider becomes a field
        hold_control(is_control);
        press_button(anywhere(), GLFW_MOUSE_BUTTON_LEFT);
        button(GLFW_RELEASE);
        frame();
        hold_control(false);
        if (is_control) type_something();
        break;
      }
      case 7:
        point_at(anywhere());
        ImGui_ImplGlfw_ScrollCallback(window_->handle(), 0.0, any(20) - 10);
        break;
      case 8:
        type_something();
        break;
      case 9:
        send_key(any_of(std::array{key::escape, key::tab, key::enter, key::up, key::backspace}), GLFW_PRESS, 0);
        break;
      case 10:
        if (any(3) == 0) act(OpenScene{std::string(any_of(shipped_scene_names()))});
        if (any(3) == 0) {
          act(ChooseInput{any_of(std::array{"mouse", "script", "circle", "virtual-falcon", "virtual-falcon"})});
        }
        if (any(4) == 0) act(StartRecording{any_of(std::array{"a.csv", "b.csv", "no/such/folder.csv"})});
        if (any(8) == 0) act(OpenScene{any_of(std::array{"a.csv", "b.csv", "broken.toml"})});
        break;
    }
    frame();
  }
  // NAN and INF: read as numbers like nan and inf, and as the name of a file they are not taken for what is looked for.
  void type_something() {
    for (const char c : std::string_view(any_of(std::array{"1e5", ".x", "-", "NAN", "INF", "0", "1e400", "%s%n",
                                                           "a.png", "b.toml", "c.csv", "d.svg", "-90", "0.001"}))) {
      send_character(static_cast<unsigned char>(c));
    }
    frame();
    if (any(4) != 0) send_key(key::enter, GLFW_PRESS, 0);
  }

  // A real device, or a thread that looks for one, has no place here for long.
  void lead_back() {
    session().folded_panels.clear();
    // Many keys lead to the stage, and one to the workbench.
    if (any(20) == 0) apply(session(), ShowFace{Face::workbench});
    if (any(40) == 0) apply(session(), ToggleMode{any_of(stage_mode_catalog()).id});
    ++frames_on_[session().face == Face::stage ? 0 : 1];
    if (any(20) == 0) session().plots.is_open = true;
    if (session().input == "falcon" || session().input == "spacemouse") act(ChooseInput{"virtual-falcon"});
    // Motors that push want somebody who takes all the steps, and that takes its time.
    if (any(30) == 0 && session().input == "virtual-falcon") {
      session().goal = {-0.02, 0.02};
      frames(20, 400);
      ++session().acknowledgements;
      ++session().arms_asked;
      frames(5, 400);
    }
    pushes_ += application_->report().motors.sent != Vector<2>(0.0) ? 1 : 0;
  }

  static inline std::string words_;  // of the last frame
  std::mt19937 random_{static_cast<unsigned>(number_from_environment("GHOSTFORCE_MONKEY_SEED", 20200417))};
  TemporaryFolder folder_;
  std::filesystem::path before_ = std::filesystem::current_path();
  int pushes_ = 0;
  std::array<int, 2> frames_on_{};  // the stage, the workbench
};

TEST_F(MonkeyTest, BreaksNothing) {
  const int events = number_from_environment("GHOSTFORCE_MONKEY_EVENTS", 1500);
  act(StartRecording{"a.csv"});
  for (int i = 0; i < events; ++i) {
    lead_back();
    do_something();
    ASSERT_TRUE(is_in_range(session().settings)) << i;
    ASSERT_TRUE(is_finite(now())) << i;
    ASSERT_LE(std::max(std::abs(session().goal.x), std::abs(session().goal.y)), farthest_mm / 1000.0) << i;
    for (const SceneView& shown : {session().shown, session().stage_shown}) {
      const SceneView nearest = within_scene_limits(shown);
      ASSERT_EQ(nearest.width, shown.width) << i;
      ASSERT_EQ(nearest.center, shown.center) << i;
    }
    ASSERT_GE(session().appearance.scale, Appearance::least_scale) << i;
    ASSERT_LE(session().appearance.scale, Appearance::greatest_scale) << i;
    // The stage's words are marks, but for what lies in front of it.
    ASSERT_TRUE(session().face == Face::stage || !words_.empty()) << i;
    ASSERT_EQ(no_number_in(words_), "") << i;
    for (const Pane& pane : screen().panes()) {
      for (const Mark& mark : pane.marks) ASSERT_TRUE(std::visit(IsSound(), mark.form)) << i;
    }
  }
  EXPECT_GT(pushes_, 0);  // motors were on
  for (const int count : frames_on_) EXPECT_GT(count, events / 10);
  // And at the end all is as it was at the beginning for who asks for it.
  press(key::escape);
  press(key::escape);
  act(ChooseInput{"mouse"});
  act(OpenScene{"wall45"});
  frames(5);
  EXPECT_EQ(session().settings, load_scene("wall45").settings);
  write_whole(folder_ / "last.toml", scene_text(scene_as_seen(session())));
  EXPECT_EQ(load_scene(folder_ / "last.toml").settings, session().settings);
}

}  // namespace
}  // namespace ghostforce::monkey_test
