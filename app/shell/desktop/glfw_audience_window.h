// GlfwAudienceWindow: the audience's window on the desktop, full screen on a monitor where the first window is not, else
// one that can be moved; F11 and a double click make it full screen. Other keys are the first window's, whichever of the
// two they reach. It shares with the first window what OpenGL keeps; offscreen it draws in its context. Main thread.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/files/image.h"
#include "app/paint/canvas.h"
#include "app/paint/gl_painter.h"
#include "app/shell/audience_window.h"

struct GLFWmonitor;
struct GLFWwindow;

namespace ghostforce {

class GlfwAudienceWindow final : public AudienceWindow {
 public:
  // What this one needs of the first window, which must outlive it and whose OpenGL is current.
  struct FirstWindow {
    GLFWwindow* handle;
    LabelFonts fonts;
    bool is_offscreen;
    // The first window's own, of what is done here.
    void (*on_key)(GLFWwindow* window, int key, int scancode, int action, int modifiers);
    void (*on_character)(GLFWwindow* window, unsigned int character);
    void (*on_change)(GLFWwindow* window);
  };
  // Throws Failure(no_display) where the desktop opens no second window.
  GlfwAudienceWindow(const FirstWindow& first, const std::string& title);
  ~GlfwAudienceWindow() override;

  bool should_close() const override;
  Vector<2> size() const override;
  void prepare(std::vector<Pane> panes, const Theme& theme) override;
  void show() override;

  GLFWwindow* handle() const noexcept { return window_.get(); }
  bool is_full_screen() const;
  const std::vector<Pane>& panes() const noexcept { return panes_; }
  // What is shown, of one that is offscreen.
  Image picture() const;

 private:
  struct Destroy {
    void operator()(GLFWwindow* window) const;
  };
  class Target;

  static void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  static void on_character(GLFWwindow* window, unsigned int character);
  static void on_button(GLFWwindow* window, int button, int action, int modifiers);
  template <typename... What>
  static void on_change(GLFWwindow* window, What... what);

  void toggle_full_screen();
  void fill(GLFWmonitor* monitor);
  void stand_beside_first();

  FirstWindow first_;
  std::unique_ptr<GLFWwindow, Destroy> window_;
  std::optional<gl::Canvas> canvas_;  // offscreen
  std::optional<GlPainter> painter_;
  ImDrawList words_;
  std::vector<Pane> panes_;
  Theme theme_;
  bool fills_monitor_ = false;  // as it was asked for; the desktop ends it where the monitor is gone
  double pressed_at_s_ = -1.0;  // when the pointer's button was pressed last, by GLFW's clock
};

// A rectangle of the desktop [screen coordinates].
struct DesktopArea {
  int x = 0, y = 0, width = 0, height = 0;
};

// The first of them that has nothing in common with `own`, as monitors have that show the same; empty: there is none.
// Pure, any thread.
std::optional<std::size_t> find_area_apart(const DesktopArea& own, std::span<const DesktopArea> all) noexcept;

}  // namespace ghostforce
