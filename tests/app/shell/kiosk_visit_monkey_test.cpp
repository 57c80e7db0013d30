// Visitors of all kinds for as many frames as GHOSTFORCE_VISIT_FRAMES says, 60 to a second, from the seed
// GHOSTFORCE_MONKEY_SEED: any key with any modifiers, the pointer, the wheel, files that are dropped, windows of any
// size, devices, and nobody for a while. Whatever they do, the next one finds a lesson.
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <variant>

#include "app/state/key_bindings.h"
#include "tests/app/shell/kiosk_visit_window.h"
#include "tests/app/shell/monkey.h"
#include "tests/support/places.h"

namespace ghostforce::kiosk_visit_monkey_test {
namespace {

constexpr int frames_of_two_minutes = 7200;

class KioskVisitMonkey : public KioskVisitWindow {
 protected:
  KioskVisitMonkey() {
    write_whole(elsewhere_ / "scene.toml", scene_text(load_scene("fig1")));
    write_whole(elsewhere_ / "lesson.toml", read_whole(source_path("/assets/lessons/ghost.toml")));
  }

  int any(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  template <typename Choices>
  auto any_of(const Choices& choices) {
    return choices[static_cast<std::size_t>(any(static_cast<int>(std::size(choices))))];
  }
  Vector<2> anywhere() {
    return {static_cast<double>(any(window_->pixel_width() + 20) - 10),
            static_cast<double>(any(window_->pixel_height() + 20) - 10)};
  }
  void frame() {
    frames(1, 16);
    ++frames_;
  }

  // Any chord but the one that ends it.
  void press_something() {
    constexpr std::array modifiers{modifier::shift, modifier::control, modifier::alt, modifier::super};
    int key = key::space + any(key::last - key::space);
    int held = 0;
    if (any(2) == 0) {
      const KeyBinding binding = any_of(key_table());
      key = binding.key;
      held = binding.modifiers;
    } else {
      for (const int modifier : modifiers) held |= any(4) == 0 ? modifier : 0;
    }
    if (key == key::q && held == (modifier::control | modifier::alt | modifier::shift)) return;
    send_key(key, any(6) == 0 ? GLFW_REPEAT : GLFW_PRESS, held);
    if (held == 0 && key < 127) send_character(static_cast<unsigned int>(key));
    frame();
    send_key(key, GLFW_RELEASE, 0);
  }

  void use_pointer() {
    const int which = any(6) == 0 ? GLFW_MOUSE_BUTTON_RIGHT : GLFW_MOUSE_BUTTON_LEFT;
    const auto& buttons = screen().stage().picture().buttons;
    // A visitor aims at what there is.
    const Vector<2> from =
        any(3) != 0 && !buttons.empty() ? 0.5 * (any_of(buttons).box.least + any_of(buttons).box.most) : anywhere();
    point_at(from);
    frame();
    button(GLFW_PRESS, which);
    frame();
    if (any(2) == 0) {
      point_at(anywhere());
      frame();
    }
    button(GLFW_RELEASE, which);
  }

  void do_something() {
    switch (any(12)) {
      case 0:
      case 1:
      case 2:
      case 3:
        return press_something();
      case 4:
      case 5:
      case 6:
      case 7:
      case 8:
        return use_pointer();
      case 9:
        point_at(anywhere());
        return ImGui_ImplGlfw_ScrollCallback(window_->handle(), 0.0, any(20) - 10);
      case 10:
        return send_key(any_of(std::array{key::page_down, key::enter}), GLFW_PRESS, 0);
      case 11:
        if (any(4) == 0) {
          const std::string path = elsewhere_ / any_of(std::array{"scene.toml", "lesson.toml", "nothing"});
          drop({path.c_str()});
        }
        if (any(4) == 0) window_->resize(640 + any(1400), 400 + any(900));
        if (any(8) == 0) ask_to_close();  // what_is_wrong() says whether it does
        if (any(8) == 0) ImGui_ImplGlfw_WindowFocusCallback(window_->handle(), any(2) == 0 ? GLFW_TRUE : GLFW_FALSE);
        return;
    }
  }

  std::string what_is_wrong() {
    if (std::string forbidden = what_is_forbidden(); !forbidden.empty()) return forbidden;
    if (!is_in_range(session().settings)) return "settings out of range";
    if (!is_finite(now())) return "the simulation is lost";
    if (!std::isfinite(session().goal.x) || !std::isfinite(session().goal.y)) return "the hand is nowhere";
    for (const Pane& pane : screen().panes()) {
      for (const Mark& mark : pane.marks) {
        if (!std::visit(IsSound(), mark.form)) return "a mark is nowhere, or says no number";
      }
    }
    return {};
  }

  void expect_start() {
    const Lesson& first = *shipped_lessons().front();
    EXPECT_EQ(session().lesson->lesson->name, first.name);
    EXPECT_EQ(session().lesson->step, 0U);
    EXPECT_EQ(session().settings, first.steps.front().set_up->scene.settings);
    EXPECT_EQ(session().goal, first.steps.front().set_up->goal);
    EXPECT_EQ(session().stage.mode, StageMode::none);
    EXPECT_EQ(session().language, "en");
    EXPECT_EQ(session().input, input_);
    EXPECT_FALSE(session().kiosk_visit->has_visitor);
  }

  void let_loose(const std::string& input) {
    input_ = input;
    begin(input);
    const int most = length_of_run("GHOSTFORCE_VISIT_FRAMES", frames_of_two_minutes) / 2;  // with each input
    std::set<std::string> lessons;
    int pauses = 0;
    for (int i = 0; frames_ < most; ++i) {
      do_something();
      frame();
      ASSERT_EQ(what_is_wrong(), "") << i;
      lessons.insert(session().lesson->lesson->name);
      if (any(150) != 0 && frames_ < most) continue;
      button(GLFW_RELEASE);
      button(GLFW_RELEASE, GLFW_MOUSE_BUTTON_RIGHT);
      frames(2);
      wait(100.0);
      ASSERT_EQ(what_is_wrong(), "") << i;
      expect_start();
      ASSERT_FALSE(HasFailure()) << i;
      ++pauses;
    }
    EXPECT_GT(pauses, 0);
    EXPECT_GT(lessons.size(), 1U);
  }

  std::mt19937 random_{static_cast<unsigned>(number_from_environment("GHOSTFORCE_MONKEY_SEED", 20261123))};
  TemporaryFolder elsewhere_;
  std::string input_;
  int frames_ = 0;
};

TEST_F(KioskVisitMonkey, FindsNoWayOutWithTheMouse) {
  let_loose("mouse");
}

TEST_F(KioskVisitMonkey, FindsNoWayOutWithADevice) {
  let_loose("virtual-falcon");
}

}  // namespace
}  // namespace ghostforce::kiosk_visit_monkey_test
