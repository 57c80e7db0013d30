// Somebody who presses, drags and types whatever there is, in any order, with every panel open and whoever moves the
// goal: nothing breaks, every value stays one that a scene may have, and no number on screen is none. ImGui's own
// assertions watch too: they end the program.
//
// As many events as GHOSTFORCE_MONKEY_EVENTS says, from the seed GHOSTFORCE_MONKEY_SEED. What it does is written down as
// it goes (app/shell/session_file.h). When something breaks, a crash too, the list is made as short as it can be and still
// break, and left in the working directory: `ghostforce replay-session` shows it.
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <glad/gl.h>
#include <imgui_internal.h>

#include "app/shell/gestures.h"
#include "app/state/key_bindings.h"
#include "app/state/scene_view.h"
#include "core/scene.h"
#include "tests/app/shell/driven_window.h"
#include "tests/app/shell/monkey.h"
#include "tests/app/shell/recorded_window.h"
#include "tests/device/servo/servo_scenes.h"
#include "tests/support/program.h"
#include "tests/support/shrink.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce::monkey_test {
namespace {

TEST(NoNumber, IsFoundAmidWords) {
  EXPECT_EQ(no_number_in("force -nan N"), "force -nan");
  EXPECT_EQ(no_number_in("x = inf"), "x = inf");
  EXPECT_EQ(no_number_in("financial information, nano, κinf"), "");
}

constexpr const char* list_variable = "GHOSTFORCE_MONKEY_LIST";
constexpr int default_seed = 20200417;

// One of those below whose names begin with DISABLED_: in a process of its own, so that a crash is seen as well.
Outcome run_alone(const std::string& test, const std::string& list) {
  ProgramCall call;
  call.words = {"--gtest_also_run_disabled_tests", "--gtest_filter=MonkeyTest.DISABLED_" + test};
  call.environment = {fmt::format("{}={}", list_variable, list), "GTEST_TOTAL_SHARDS=1", "GTEST_SHARD_INDEX=0",
                      "GTEST_OUTPUT="};
  return run_program(std::filesystem::read_symlink("/proc/self/exe").string(), call);
}

// What to say of it.
std::string shrink_list(const std::string& path) {
  constexpr int most_tries = 300;
  RecordedSession session = load_session(path);
  const std::size_t all = session.actions.size();
  const TemporaryFolder folder;
  const auto fails = [&](const std::vector<TimedAction>& actions) {
    constexpr double afterwards_s = 0.1;
    RecordedSession shorter{session.start, actions, actions.empty() ? 0.0 : actions.back().time_s + afterwards_s};
    const std::string list = folder / "shorter.session";
    write_whole(list, session_text(shorter));
    if (run_alone("DoesAsListed", list).exit_code == 0) return false;
    write_whole(path, session_text(shorter));  // the shortest so far
    return true;
  };
  if (!fails(session.actions)) {
    return fmt::format(
        "It takes more than these {} actions: pointer and keys in the window, or this seed. They are in {}", all, path);
  }
  const std::size_t left = shrink<TimedAction>(session.actions, fails, most_tries).size();
  return fmt::format("{} of its {} actions are enough: ghostforce replay-session {}", left, all, path);
}

TEST(Monkey, BreaksNothing) {
  const std::string path = std::filesystem::absolute(
      fmt::format("monkey-{}.session", number_from_environment("GHOSTFORCE_MONKEY_SEED", default_seed)));
  std::filesystem::remove(path);
  const Outcome outcome = run_alone("DoesWhatItLikes", path);
  if (outcome.exit_code == 0) {
    std::filesystem::remove(path);
    return;
  }
  ADD_FAILURE() << outcome.out << outcome.err << "exit code " << outcome.exit_code;
  if (std::filesystem::exists(path)) ADD_FAILURE() << shrink_list(path);
}

class MonkeyTest : public RecordedWindow {
 protected:
  // High enough for every panel at once.
  static constexpr int width = 1280;
  static constexpr int height = 2400;

  MonkeyTest() { std::filesystem::current_path(folder_.path()); }
  void begin() {
    ApplicationOptions options;
    // Nobody's: no monkey drives a real one.
    options.inputs = desktop_inputs({.falcon = {.id = {0xFFFF, 0xFFFF}}, .haply = {.path = "/dev/none"}});
    open_recorded(list_path(), std::move(options), "wall45", width, height);
    look_at_words();
  }
  static std::string list_path() {
    const char* const path = std::getenv(list_variable);
    return path == nullptr ? "monkey.session" : path;
  }
  void look_at_words() {
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
  void frame() { frames(any(8) == 0 ? 1 + any(6) : 1); }
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
    if (any(20) == 0) act(ShowFace{Face::workbench});
    if (any(40) == 0) act(ToggleMode{any_of(stage_mode_catalog()).id});
    ++frames_on_[session().face == Face::stage ? 0 : 1];
    if (any(20) == 0 && !session().plots.is_open) act(TogglePlots{});
    if (session().input == "falcon" || session().input == "spacemouse") act(ChooseInput{"virtual-falcon"});
    // Motors that push want somebody who takes all the steps, and that takes its time.
    if (any(100) == 0 && session().input == "virtual-falcon") {
      act(MoveHandTo{{-0.02, 0.02}});
      act(LetGoOfHand{});
      frames(480);
      act(AcknowledgeOff{});
      act(ArmMotors{});
      frames(120);
    }
    pushes_ += application_->report().motors.sent != Vector<2>(0.0) ? 1 : 0;
  }

  // What must be so at any moment, whatever was done. Empty: all is.
  std::string what_is_wrong() {
    if (!is_in_range(session().settings)) return "settings are out of range";
    // Of a hand that aims at the target, the ghost force is unknown until the motors give all of their force.
    Snapshot known = now();
    if (known.measured && known.has_target) known.strategies[index_of(*known.measured)].ghost_force = Vector<2>(0.0);
    if (!is_finite(known)) return "the simulation is lost";
    if (std::max(std::abs(session().goal.x), std::abs(session().goal.y)) > farthest_mm / 1000.0)
      return "the hand is too far away";
    for (const SceneView& shown : {session().shown, session().stage_shown}) {
      const SceneView nearest = within_scene_limits(shown);
      if (nearest.width != shown.width || nearest.center != shown.center) return "a view is beyond its limits";
    }
    const double scale = session().appearance.scale;
    if (!(scale >= Appearance::least_scale && scale <= Appearance::greatest_scale)) return "letters have no such size";
    // The stage's words are marks, but for what lies in front of it.
    if (session().face != Face::stage && words_.empty()) return "the workbench has no words";
    if (const std::string_view word = no_number_in(words_); !word.empty()) return "no number: " + std::string(word);
    for (const Pane& pane : screen().panes()) {
      for (const Mark& mark : pane.marks) {
        if (!std::visit(IsSound(), mark.form)) return "a mark is nowhere, or says no number";
      }
    }
    return {};
  }

  static inline std::string words_;  // of the last frame
  std::mt19937 random_{static_cast<unsigned>(number_from_environment("GHOSTFORCE_MONKEY_SEED", default_seed))};
  TemporaryFolder folder_;
  std::filesystem::path before_ = std::filesystem::current_path();
  int pushes_ = 0;
  std::array<int, 2> frames_on_{};  // the stage, the workbench
};

TEST_F(MonkeyTest, DISABLED_DoesAsListed) {
  open_replayed(load_session(list_path()));
  look_at_words();
  do {
    replay_->step();
    ASSERT_EQ(what_is_wrong(), "");
  } while (!replay_->is_over());
}

TEST_F(MonkeyTest, DISABLED_DoesWhatItLikes) {
  const int events = length_of_run("GHOSTFORCE_MONKEY_EVENTS", 1500);
  begin();
  act(StartRecording{"a.csv"});
  for (int i = 0; i < events; ++i) {
    lead_back();
    do_something();
    ASSERT_EQ(what_is_wrong(), "") << i;
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
