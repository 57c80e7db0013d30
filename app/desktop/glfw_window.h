// The desktop's window, by GLFW, with OpenGL 3.3 core: on a display, or offscreen (GLFW's null platform with an OSMesa
// context, drawn in software into memory). One code path; only the two hints in glfw_window.cpp differ.
#pragma once

#include <memory>
#include <string>

#include "app/ui/window.h"

struct GLFWwindow;

namespace ghostforce {

struct WindowOptions {
  std::string title;
  int width = 1280;  // [screen coordinates]
  int height = 800;
  bool offscreen = false;
  bool fits_monitor = false;  // smaller where the monitor is
  bool takes_mouse = true;    // false: no hover and no click changes a picture
};

class GlfwWindow : public Window {
 public:
  // Throws Failure(no_display): no display, or no OpenGL 3.3 (says which renderer and version there is).
  explicit GlfwWindow(const WindowOptions& options);
  ~GlfwWindow() override;

  GLFWwindow* handle() const noexcept { return window_.get(); }

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
  std::string clipboard_text() const override;
  DisplayKind display_kind() const override;

 protected:
  WindowSize framebuffer_size() const override;
  void take_events(double wait_s) override;
  void begin_imgui_frame() override;
  void show_frame() override;

 private:
  struct Library {  // glfwInit … glfwTerminate
    explicit Library(const WindowOptions& options);
    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
  };
  struct Destroy {
    void operator()(GLFWwindow* window) const;
  };

  WindowSize size() const;
  template <typename... What>
  static void on_anything(GLFWwindow* window, What... what);
  template <typename... What>
  static void on_act(GLFWwindow* window, What... what);
  static void on_pointer(GLFWwindow* window, double x, double y);
  static void on_key(GLFWwindow* window, int key, int scancode, int action, int modifiers);
  static void on_character(GLFWwindow* window, unsigned int character);
  static void on_resize(GLFWwindow* window, int width, int height);
  static void on_drop(GLFWwindow* window, int count, const char** paths);

  Library library_;
  std::unique_ptr<GLFWwindow, Destroy> window_;
  WindowSize restored_size_;  // the last one while neither maximised nor full screen
  struct {
    int x = 0, y = 0;
  } restored_corner_;
};

}  // namespace ghostforce
