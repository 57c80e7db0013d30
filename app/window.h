// A window with OpenGL 3.3 core and Dear ImGui in it: on a display, or offscreen (GLFW's null platform with an OSMesa
// context, drawn in software into memory). One code path; only the two hints in window.cpp differ. Main thread only,
// one at a time.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <imgui.h>

#include "app/image.h"

struct GLFWwindow;

namespace ghostforce {

struct WindowOptions {
  std::string title;
  int width = 1280;  // [screen coordinates]
  int height = 800;
  bool offscreen = false;
  bool takes_mouse = true;  // false: no hover and no click changes a picture
};

class Window {
 public:
  // Throws Failure(no_display): no display, or no OpenGL 3.3 (says which renderer and version there is).
  explicit Window(const WindowOptions& options);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const noexcept { return window_.get(); }
  bool should_close() const;
  void close();
  void resize(int width, int height);

  // Of the display: what makes text on a dense screen as large as on an ordinary one.
  float display_scale() const;
  // Framebuffer pixels; 0×0 while minimised.
  int pixel_width() const;
  int pixel_height() const;

  // Takes what keyboard and mouse did, waiting at most that long for something to happen [s].
  void poll(double wait_s);

  // One frame: `draw` runs between ImGui's NewFrame and Render; then everything is shown.
  void frame(const std::function<void()>& draw);

  // What the last frame() drew.
  Image picture() const;

  // "renderer, version" of the OpenGL in use.
  std::string graphics_description() const;

  ImFont* regular_font() const noexcept { return regular_font_; }
  ImFont* bold_font() const noexcept { return bold_font_; }
  ImFont* number_font() const noexcept { return number_font_; }

 private:
  struct Library {  // glfwInit … glfwTerminate
    explicit Library(bool offscreen);
    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
  };
  struct Destroy {
    void operator()(GLFWwindow* window) const;
  };

  void start_imgui(bool takes_mouse);

  Library library_;
  std::unique_ptr<GLFWwindow, Destroy> window_;
  ImFont* regular_font_ = nullptr;
  ImFont* bold_font_ = nullptr;
  ImFont* number_font_ = nullptr;
};

}  // namespace ghostforce
