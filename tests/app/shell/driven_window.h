// The whole program offscreen: the real window, ImGui and OpenGL, driven through the backend's own callbacks as a
// display would drive them, with the servo stepped by hand.
#pragma once

#include "app/shell/application.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui_impl_glfw.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/desktop_inputs.h"
#include "app/files/scene_file.h"
#include "app/paint/vector/vector_file_painter.h"
#include "app/shell/desktop/glfw_window.h"
#include "app/state/keys.h"
#include "device/virtual_falcon/virtual_falcon_input.h"
#include "tests/support/screen_text.h"

namespace ghostforce {

inline constexpr double frame_s = 1.0 / 60.0;

inline Colour pixel(const Image& image, int x, int y) {
  const std::size_t at =
      3U * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

class DrivenWindow : public testing::Test {
 protected:
  DrivenWindow() { open({}); }

  // Opens anew, with the desktop's painter, and its inputs where the options have none; what was there before is gone.
  void open(ApplicationOptions options, const std::string& scene = "wall45", int width = 1280, int height = 800) {
    application_.reset();
    if (options.inputs.empty()) options.inputs = desktop_inputs();
    options.painter = cairo_file_painter();
    if (!window_ || window_->pixel_width() != width || window_->pixel_height() != height) open_window(width, height);
    application_ = std::make_unique<Application>(*window_, load_scene(scene), options);
    point_at(width - 400.0, height - 5.0);  // nothing there
    frames(3);
  }

  // With the virtual Falcon, whose clock the servo's steps move, until it is ready to be armed.
  void open_virtual_falcon(ApplicationOptions options = {}) {
    options.input = "virtual-falcon";
    options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
    open(std::move(options));
    ASSERT_TRUE(frames_until(30.0, [&] { return virtual_falcon().report().state == FalconState::idle; }));
  }

  void open_window(int width, int height) {
    window_.reset();
    window_ = std::make_unique<GlfwWindow>(
        WindowOptions{.title = "test", .width = width, .height = height, .offscreen = true, .takes_mouse = true});
    ImGui_ImplGlfw_WindowFocusCallback(window_->handle(), GLFW_TRUE);
    ImGui_ImplGlfw_CursorEnterCallback(window_->handle(), GLFW_TRUE);
    window_->set_visible_drawing(draws_every_frame_);
  }

  Session& session() { return application_->session(); }
  // As a panel or a dialog does.
  void act(const Action& action) { application_->act(action); }
  const Screen& screen() const { return application_->screen(); }
  const Snapshot& now() const { return application_->report().snapshot; }
  // Where that is the input in use.
  VirtualFalconInput& virtual_falcon() { return dynamic_cast<VirtualFalconInput&>(application_->servo().input()); }
  const Window& window() const { return *window_; }
  // What is on the window. Pixels are drawn only here: in software they are most of a frame's work.
  Image picture() {
    if (!draws_every_frame_) {
      window_->set_visible_drawing(true);
      application_->draw();
      window_->set_visible_drawing(false);
    }
    return window_->picture();
  }
  // For pictures that the program makes of itself, and for those that it draws once and keeps.
  void draw_every_frame() {
    draws_every_frame_ = true;
    window_->set_visible_drawing(true);
  }

  // A frame of the window and the ticks that the servo makes meanwhile.
  void frames(int count, int ticks_per_frame = 16) {
    for (int i = 0; i < count; ++i) {
      for (int k = 0; steps_by_hand_ && k < ticks_per_frame; ++k) application_->servo().step();
      application_->frame(frame_s);
    }
  }

  // Few of the window and many ticks: drawing is what takes the time. Of model time, at 1 kHz.
  bool frames_until(double seconds, const std::function<bool()>& is_so) {
    for (double t = 0.0; t < seconds && !is_so(); t += 0.1) frames(1, 100);
    return is_so();
  }
  // The hand, slowly enough for a hand.
  void lead_to(const Vector<2>& goal) {
    const Vector<2> from = session().goal;
    for (int i = 1; i <= 10; ++i) {
      session().goal = glm::mix(from, goal, i / 10.0);
      frames(1, 100);
    }
    frames(10, 100);
  }

  void point_at(double x, double y) { ImGui_ImplGlfw_CursorPosCallback(window_->handle(), x, y); }
  void point_at(const Vector<2>& at) { point_at(at.x, at.y); }
  void button(int action, int which = GLFW_MOUSE_BUTTON_LEFT) {
    ImGui_ImplGlfw_MouseButtonCallback(window_->handle(), which, action, 0);
  }
  void click_at(double x, double y) {
    point_at(x, y);
    frames(2);
    button(GLFW_PRESS);
    frames(2);
    button(GLFW_RELEASE);
    frames(2);
  }
  // A button of the stage, in the middle, where the last frame had it.
  void click_on(const StageAction& action) {
    const auto& buttons = screen().stage().picture().buttons;
    const auto found = std::ranges::find(buttons, action, &StageButton::action);
    ASSERT_NE(found, buttons.end());
    const Vector<2> middle = 0.5 * (found->box.least + found->box.most);
    click_at(middle.x, middle.y);
  }
  void press_at(const Vector<2>& at, int which = GLFW_MOUSE_BUTTON_LEFT) {
    point_at(at);
    frames(2);
    button(GLFW_PRESS, which);
    frames(2);
  }
  void release(int which = GLFW_MOUSE_BUTTON_LEFT) {
    button(GLFW_RELEASE, which);
    frames(2);
  }
  void drag(const Vector<2>& from, const Vector<2>& to, int which = GLFW_MOUSE_BUTTON_LEFT) {
    press_at(from, which);
    point_at(0.5 * (from + to));
    frames(2);
    point_at(to);
    frames(2);
    release(which);
  }
  void scroll(double notches) {
    ImGui_ImplGlfw_ScrollCallback(window_->handle(), 0.0, notches);
    frames(2);
  }

  // As quick as a chord can be: all of it comes between two frames, and the modifier is let go of first.
  void press(int key, int modifiers = 0) {
    send_key(key, GLFW_PRESS, modifiers);
    send_key(key, GLFW_RELEASE, 0);
    frames(3);
  }
  void send_key(int key, int action, int modifiers) {
    const GLFWkeyfun on_key = glfwSetKeyCallback(window_->handle(), nullptr);
    glfwSetKeyCallback(window_->handle(), on_key);
    on_key(window_->handle(), key, glfwGetKeyScancode(key), action, modifiers);
  }
  void send_character(unsigned int character) {
    const GLFWcharfun on_character = glfwSetCharCallback(window_->handle(), nullptr);
    glfwSetCharCallback(window_->handle(), on_character);
    on_character(window_->handle(), character);
  }
  // As X11 tells it: without itself when it goes down, and with itself when it comes up.
  void hold_control(bool is_down) {
    send_key(key::left_control, is_down ? GLFW_PRESS : GLFW_RELEASE, is_down ? 0 : modifier::control);
  }
  void type(const std::string& text) {
    for (const char c : text) send_character(static_cast<unsigned char>(c));
    frames(2);
  }
  // Files as a file manager drops them.
  void drop(std::vector<const char*> paths) {
    const GLFWdropfun on_drop = glfwSetDropCallback(window_->handle(), nullptr);
    glfwSetDropCallback(window_->handle(), on_drop);
    on_drop(window_->handle(), static_cast<int>(paths.size()), paths.data());
    frames(3);
  }

  Vector<2> on_window(const Vector<2>& world, std::size_t pane = 0) const {
    const Pane& which = screen().panes()[pane];
    return in_window(to_screen(which.camera, world) + which.corner);
  }
  // From a place in the scene to one in the window.
  Vector<2> in_window(const Vector<2>& in_scene) const {
    return {in_scene.x + static_cast<double>(screen().scene_corner().x),
            in_scene.y + static_cast<double>(screen().scene_corner().y)};
  }
  // Where the last frame has words that begin so, beside those on the scene.
  static std::optional<Vector<2>> place_of(std::string_view beginning) {
    for (const ScreenWords& words : words_on_screen()) {
      const ImVec2 middle = words.ink.GetCenter();
      if (words.text.starts_with(beginning)) {
        return Vector<2>(static_cast<double>(middle.x), static_cast<double>(middle.y));
      }
    }
    return std::nullopt;
  }
  void click_on_words(std::string_view beginning) {
    const std::optional<Vector<2>> place = place_of(beginning);
    ASSERT_TRUE(place) << beginning << " is not on the screen";
    click_at(place->x, place->y);
    frames(2);
  }
  // Whether it has these words, which may be broken into lines.
  static bool says(std::string_view sought) {
    std::string all;
    for (const ScreenWords& words : words_on_screen()) all += words.text + " ";
    return all.find(sought) != std::string::npos;
  }
  // All words on the scene, in the order in which they are drawn.
  std::string words_of_scene() const {
    std::string all;
    for (const Mark& mark : screen().panes().front().marks) {
      if (const auto* const label = std::get_if<Label>(&mark.form)) all += label->text + " ";
    }
    return all;
  }
  bool scene_says(std::string_view words) const { return words_of_scene().find(words) != std::string::npos; }
  // What there is to tell; empty: nothing.
  std::string notice() { return session().notice ? session().notice->words : ""; }
  bool is_problem() { return session().notice && session().notice->is_problem; }

  // Where a pane has a mark of that role, such as the goal [m].
  static Vector<2> place_of_mark(const Pane& pane, Role role) {
    for (const Mark& mark : pane.marks) {
      const auto* const marker = std::get_if<Marker>(&mark.form);
      if (marker != nullptr && mark.role == role) return marker->center;
    }
    ADD_FAILURE() << "not there";
    return {};
  }
  int count_marks(Role role, std::optional<StrategyId> id = {}) const {
    int count = 0;
    for (const Pane& pane : screen().panes()) {
      for (const Mark& mark : pane.marks) count += mark.role == role && (!id || mark.strategy == id) ? 1 : 0;
    }
    return count;
  }

  bool draws_every_frame_ = false;
  bool steps_by_hand_ = true;  // else a driver makes the ticks
  std::unique_ptr<GlfwWindow> window_;
  std::unique_ptr<Application> application_;
};

}  // namespace ghostforce
