// OpenGlWindow: GLFW's window with OpenGL 3.3 core, on a display or offscreen, and the memory that OpenGL needs.
// Offscreen it is GLFW's null platform, which keeps the input side, with EGL or OSMesa beside it; neither has a
// framebuffer that may be drawn on, so that what is drawn needs a gl::Canvas, and is the same with both. Main thread
// only, one at a time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/shell/desktop/display_watch.h"
#include "app/shell/desktop/egl_context.h"
#include "app/shell/desktop/renderer.h"
#include "app/shell/window.h"

struct GLFWmonitor;
struct GLFWwindow;

namespace ghostforce {

struct WindowOptions {
  std::string title;
  int width = 1280;  // [screen coordinates]
  int height = 800;
  bool offscreen = false;
  std::optional<Renderer>
      renderer{};             // that draws offscreen; empty: the first that is there and needs no graphics card
  bool fits_monitor = false;  // smaller where the monitor is
  bool takes_mouse = true;    // false: no hover and no click changes a picture
  // Called at once, on another thread, when a display or its window is lost; null: nothing is. The program ends a
  // little later, with words (display_watch.h).
  void (*when_lost)() noexcept = nullptr;
};

class OpenGlWindow {
 public:
  // By that renderer offscreen, or on a display. OpenGL is loaded, and current from here on. Throws Failure: no_display
  // where there is no display, no OpenGL 3.3, or not that renderer, and says what there is and what to install;
  // file_trouble without memory for it.
  OpenGlWindow(const WindowOptions& options, std::optional<Renderer> renderer);

  // As the options have it. Throws the same.
  static OpenGlWindow open(const WindowOptions& options);

  GLFWwindow* handle() const noexcept { return window_.get(); }
  // Null where GLFW itself is told (Wayland), and offscreen.
  const DisplayWatch* watch() const noexcept { return watch_ ? &*watch_ : nullptr; }

  // Finds OpenGL's functions.
  using Loader = EglContext::Loader;
  Loader loader() const;

 private:
  struct Library {  // glfwInit … glfwTerminate
    Library(const WindowOptions& options, std::optional<Renderer> renderer);
    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
  };
  struct Destroy {
    void operator()(GLFWwindow* window) const;
  };

  Library library_;
  std::unique_ptr<GLFWwindow, Destroy> window_;
  std::optional<EglContext> egl_;      // empty: the window has a context of its own
  std::optional<DisplayWatch> watch_;  // of an X server's
};

// Before OpenGL is loaded, for a window of that size [px]: its libraries crash or hang where a limit of the process
// (ulimit -v) leaves them too little memory, so it is asked for beforehand. Where there is room for it only without
// threads of the software renderer, or none may be started (ulimit -u), that gets none, and draws the same more slowly. Throws Failure(file_trouble) where
// there is no room, whose words end in what else the person can do, the `remedy`.
void make_room_for_drawing(int width, int height, std::string_view remedy);

// What GLFW is to make of the next window: one with an OpenGL of its own on a display, or by OSMesa; or else with none.
void hint_window(std::optional<Renderer> renderer);

// A window's size, at most as large as what the desktop leaves free of the primary monitor; as WindowOptions has it.
WindowSize fitted(WindowSize size);

// The monitor that shows most of the window; null: there is none.
GLFWmonitor* monitor_of(GLFWwindow* window);

}  // namespace ghostforce
