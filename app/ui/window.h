// A window with OpenGL 3.3 core and Dear ImGui in it: on a display, or offscreen (GLFW's null platform with an OSMesa
// context, drawn in software into memory). One code path; only the two hints in window.cpp differ. Main thread only,
// one at a time.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/files/clipboard_tool.h"
#include "app/files/image.h"
#include "app/session/key_bindings.h"
#include "app/ui/widgets/panel_context.h"
#include "app/ui/window_size.h"

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

// What the keyboard did: a key went down or up, or a character came without a key, from an input method.
struct KeyEvent {
  KeyPress press;               // press.key == 0: a character alone
  bool is_down = true;          // false: the key went up
  int scancode = 0;             // of the key
  std::uint32_t character = 0;  // that it has typed; 0: none
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
  // From now on only close() closes it: neither its close button nor the desktop does, and it is not hidden when another
  // window is in front of it.
  void stay_open();
  void set_title(const std::string& title);
  void resize(int width, int height);

  // Of the display: what makes text on a dense screen as large as on an ordinary one.
  float display_scale() const;
  // Framebuffer pixels; 0×0 while minimised.
  int pixel_width() const;
  int pixel_height() const;

  // Fills the monitor that the window is on, and back to where it was.
  void toggle_full_screen();
  bool is_full_screen() const;
  bool is_maximized() const;
  // Keys reach it.
  bool has_focus() const;
  void maximize();
  // Neither maximised nor full screen, and of this size, as WindowOptions has it.
  void restore(int width, int height);
  // As it is while neither maximised nor full screen, as WindowOptions has it: before the display's scale.
  WindowSize restored_size() const;

  // What the keyboard did and nobody has taken yet, in its order. Dear ImGui sees of it only what is handed on to it.
  std::deque<KeyEvent>& key_events() noexcept { return key_events_; }
  static void hand_on(const KeyEvent& event);

  // For other programs to paste.
  void set_clipboard_text(const std::string& text);
  // Empty where there is none.
  std::string clipboard_text() const;
  // The desktop that a tool of the system would have to speak to.
  DisplayKind display_kind() const;

  // Files that were dropped on the window since the last call.
  std::vector<std::string> take_dropped_files();

  // What somebody has done with keyboard and pointer since the last call.
  struct Touch {
    bool has_acted = false;  // keys, buttons, the wheel
    bool has_moved = false;  // the pointer, or the window under it
  };
  Touch take_touch() noexcept;

  // Takes what keyboard and mouse did, waiting at most that long for something to happen [s]. True: something did, by
  // the person or the desktop.
  bool poll(double wait_s);

  // One frame: `draw` runs between ImGui's NewFrame and Render; then everything is shown. `interval_s` is the time
  // since the frame before: the screen reads no clock, so that what a double click is does not depend on how busy a
  // machine is.
  void frame(double interval_s, const std::function<void()>& draw);

  // False: frames run to their end, only that no pixel is touched; on a software renderer that is most of the work.
  void set_visible_drawing(bool is_on);

  // What the last frame() drew.
  Image picture() const;

  // A frame that is not shown, `density` times as fine as the window, without pointer. pixel_width() and
  // pixel_height() are the picture's meanwhile. Throws Failure(wrong_call) where the driver cannot draw that large.
  Image picture_of(int density, const std::function<void()>& draw);

  // "renderer, version" of the OpenGL in use.
  std::string graphics_description() const;

  const Fonts& fonts() const noexcept { return fonts_; }

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

  void start_imgui(bool takes_mouse);
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
  Fonts fonts_{};
  int density_ = 1;           // of the frame that is being drawn
  WindowSize restored_size_;  // the last one while neither maximised nor full screen
  struct {
    int x = 0, y = 0;
  } restored_corner_;
  std::deque<KeyEvent> key_events_;
  bool awaits_character_ = false;  // of the newest of them it is not known yet what it types
  std::vector<std::string> dropped_files_;
  bool is_stirred_ = false;  // since the last poll
  Touch touch_;              // since the last take_touch
};

}  // namespace ghostforce
