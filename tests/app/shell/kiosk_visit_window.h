// The visitor's mode in the offscreen window, in a folder of its own where nothing must ever appear.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/state/kiosk_visit.h"
#include "app/state/lesson_file.h"
#include "tests/app/shell/driven_window.h"
#include "tests/device/servo/servo_scenes.h"
#include "tests/support/temporary_folder.h"

namespace ghostforce {

class KioskVisitWindow : public DrivenWindow {
 protected:
  KioskVisitWindow() {
    for (const char* const name : {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"}) {
      setenv(name, folder_.path().c_str(), 1);
    }
    std::filesystem::current_path(folder_.path());
  }
  ~KioskVisitWindow() override { std::filesystem::current_path(before_); }

  void begin(const std::string& input = "mouse", std::vector<std::shared_ptr<const Lesson>> lessons = {}) {
    ApplicationOptions options;
    options.face = Face::stage;
    options.kiosk_visit = lessons.empty() ? shipped_lessons() : std::move(lessons);
    options.input = input;
    options.input_options.virtual_falcon_clock = VirtualLink::Clock::stepped;
    // Nobody's: no test drives a real one.
    options.inputs = desktop_inputs({.falcon = {.id = {0xFFFF, 0xFFFF}}, .haply = {.path = "/dev/none"}});
    open(options);
  }

  // As GLFW passes on what the close button, Alt+F4 and the desktop ask for.
  void ask_to_close() {
    glfwSetWindowShouldClose(window_->handle(), GLFW_TRUE);
    const GLFWwindowclosefun on_close = glfwSetWindowCloseCallback(window_->handle(), nullptr);
    ASSERT_NE(on_close, nullptr);
    glfwSetWindowCloseCallback(window_->handle(), on_close);
    on_close(window_->handle());
  }

  // Nobody touches anything meanwhile.
  void wait(double seconds) {
    constexpr double interval_s = 0.5;
    for (double passed_s = 0.0; passed_s < seconds; passed_s += interval_s) application_->frame(interval_s);
  }

  // What must be so at any moment, whatever was done. Empty: all is.
  std::string what_is_forbidden() {
    const Session& now = session();
    if (!now.kiosk_visit || !now.lesson) return "the lesson is gone";
    if (now.face != Face::stage) return "the workbench is there";
    if (now.dialog != Dialog::none) return "a dialog is open";
    if (now.notice) return "a notice is there: " + now.notice->words;
    if (now.paused) return "time stands still";
    if (now.stage.is_black) return "the stage is black";
    if (now.stage.hides_numbers) return "the numbers are hidden";
    if (now.stage.looks_back_to_s) return "the stage looks back";
    if (now.appearance != appearance_) return "it looks other";
    if (now.scene->title != scene_title_) return "another scene is open";
    if (application_->reading().recording.is_on) return "a recording is made";
    if (folder_.count() != 0) return "something was written";
    if (window_->should_close()) return "the window closes";
    return {};
  }

  TemporaryFolder folder_;

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
  Appearance appearance_;
  std::string scene_title_ = load_scene("wall45").title;
};

}  // namespace ghostforce
