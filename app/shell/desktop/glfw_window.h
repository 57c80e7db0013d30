// The desktop's window, by GLFW: on a display, or offscreen, where it is drawn into memory. One code path; what differs
// is in opengl_window.h, and that an offscreen window draws on a canvas. And the monitors that it may be on. Main
// thread, between GLFW's beginning and its end.
#pragma once

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "app/paint/canvas.h"
#include "app/shell/desktop/opengl_window.h"
#include "app/shell/desktop/wayland_clipboard.h"
#include "app/shell/desktop/x11_clipboard.h"
#include "app/shell/window.h"

struct GLFWwindow;

namespace ghostforce {

class GlfwWindow : public Window {
 public:
  // Throws what OpenGlWindow::open() does.
  explicit GlfwWindow(const WindowOptions& options);
  ~GlfwWindow() override;

  GLFWwindow* handle() const noexcept { return opengl_.handle(); }
  // As the desktop's portals call it; empty: they have no name for it.
  std::string portal_name() const;

  bool should_close() const override;
  void close() override;
  void stay_open() override;
  void set_title(const std::string& title) override;
  void resize(int width, int height) override;
  float display_scale() const override;
  void toggle_full_screen() override;
  bool is_full_screen() const override;
  bool is_maximized() const override;
  bool has_focus() const override;
  void maximize() override;
  void restore(int width, int height) override;
  WindowSize restored_size() const override;
  void set_clipboard_text(const std::string& text) override;
  std::optional<std::string> clipboard_text() override;
  DisplayKind display_kind() const override;
  std::unique_ptr<AudienceWindow> open_audience(const std::string& title) override;

 protected:
  WindowSize framebuffer_size() const override;
  void take_events(double wait_s) override;
  void begin_imgui_frame() override;
  void show_frame() override;

 private:
  WindowSize size() const;
  template <typename... What>
  static void on_anything(GLFWwindow* window, What... what);
  template <typename... What>
  static void on_act(GLFWwindow* window, What... what);
  static void on_focus(GLFWwindow* window, int is_focused);
  static void on_pointer(GLFWwindow* window, double x, double y);
  static void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  static void on_character(GLFWwindow* window, unsigned int character);
  static void on_resize(GLFWwindow* window, int width, int height);
  static void on_drop(GLFWwindow* window, int count, const char** paths);

  void fit_canvas();
  void begin_reading();
  void take_text_read();

  OpenGlWindow opengl_;
  std::optional<X11Clipboard> x11_clipboard_;  // after GLFW, which it needs
  std::optional<WaylandClipboard> wayland_clipboard_;
  struct {
    std::future<std::string> reading;  // invalid: nothing is being read
    std::jthread reader;               // waits at most as long as a reading may
    int asked = 0;                     // while it is being read, how often
    std::string text;
    int untaken = 0;         // of those that have asked; 0 once all keys have been taken
    std::string field_text;  // pasted into a field of Dear ImGui
  } pasting_;
  std::optional<gl::Canvas> canvas_;       // offscreen
  std::optional<gl::Renderbuffer> depth_;  // of the canvas
  bool was_told_of_focus_ = true;
  WindowSize restored_size_;  // the last one while neither maximised nor full screen
  struct {
    int x = 0, y = 0;
  } restored_corner_;
};

}  // namespace ghostforce
