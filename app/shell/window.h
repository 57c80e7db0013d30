// A window with OpenGL and Dear ImGui in it: what all windows have in common. What a platform does is for a class of
// its own: the desktop's GlfwWindow, on a display or offscreen. With the few things that all that is drawn in a window
// agrees on: windows of Dear ImGui that stand still, and how much of them a picture shows. Main thread only, one window
// at a time.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>
#include <imgui_internal.h>

#include "app/files/clipboard_tool.h"
#include "app/files/image.h"
#include "app/picture/theme.h"
#include "app/state/faces_and_modes.h"
#include "app/state/key_bindings.h"
#include "app/widgets/panel_context.h"

namespace ghostforce {

class AudienceWindow;

// In a smaller window the bars have no room for their words [screen coordinates].
inline constexpr int least_window_width = 480;
inline constexpr int least_window_height = 360;

// How large a window is.
struct WindowSize {
  int width = 0;
  int height = 0;
};

// What the keyboard did: a key went down or up, or a character came without a key, from an input method.
struct KeyEvent {
  KeyPress press;               // press.key == 0: a character alone
  bool is_down = true;          // false: the key went up
  std::uint32_t character = 0;  // that it has typed; 0: none
};

class Window {
 public:
  virtual ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  virtual bool should_close() const = 0;
  virtual void close() = 0;
  // From now on only close() closes it: neither its close button nor the desktop does, and it is not hidden when
  // another window is in front of it.
  virtual void stay_open() = 0;
  virtual void set_title(const std::string& title) = 0;
  // [screen coordinates]
  virtual void resize(int width, int height) = 0;

  // Of the display: what makes text on a dense screen as large as on an ordinary one.
  virtual float display_scale() const = 0;
  // Framebuffer pixels; 0×0 while minimised.
  int pixel_width() const;
  int pixel_height() const;

  // Fills the monitor that the window is on, and back to where it was.
  virtual void toggle_full_screen() = 0;
  virtual bool is_full_screen() const = 0;
  virtual bool is_maximized() const = 0;
  // Keys reach it.
  virtual bool has_focus() const = 0;
  virtual void maximize() = 0;
  // Neither maximised nor full screen, and of this size before the display's scale.
  virtual void restore(int width, int height) = 0;
  // As it is while neither maximised nor full screen, before the display's scale.
  virtual WindowSize restored_size() const = 0;

  // What the keyboard did and nobody has taken yet, in its order. Dear ImGui sees of it only what is handed on to it.
  std::deque<KeyEvent>& key_events() noexcept { return key_events_; }
  static void hand_on(const KeyEvent& event);

  // For other programs to paste.
  virtual void set_clipboard_text(const std::string& text) = 0;
  // "" where the clipboard has none. Empty: it is being read, and once the text is there the window tells Ctrl+V again,
  // as often as it was asked for.
  virtual std::optional<std::string> clipboard_text() = 0;
  // Why the text that was asked for does not come, and what to do, once; empty: nothing is wrong.
  std::string take_clipboard_problem() noexcept { return std::exchange(clipboard_problem_, {}); }
  // The desktop that a tool of the system would have to speak to.
  virtual DisplayKind display_kind() const = 0;

  // Files that were dropped on the window since the last call.
  std::vector<std::string> take_dropped_files();

  // A second window, for an audience; null where the platform has none. It must not outlive this one. Throws Failure.
  virtual std::unique_ptr<AudienceWindow> open_audience(const std::string& title);

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
  static std::string graphics_description();

  const Fonts& fonts() const noexcept { return fonts_; }

 protected:
  // --- For a platform's window: its life ---

  // Dear ImGui is there from here to the end of ~Window(), so a platform's constructor may set its flags, and its
  // clipboard; it must not begin a frame.
  Window();
  // In a platform's constructor, once OpenGL is current and loaded: Dear ImGui's drawing and the fonts. `takes_mouse`
  // is false where no hover and no click may change a picture. Throws Failure where a font is missing; then it has not
  // begun.
  void start_drawing(bool takes_mouse);
  // While OpenGL still is current: the destructor of a platform's window begins with it.
  void stop_drawing() noexcept;
  // With another OpenGL context in place of the one before, which has gone with all that was in it.
  void restart_drawing();

  // --- What a platform's window must know and do besides the public functions ---

  // Of the framebuffer [px]; 0×0 while minimised.
  virtual WindowSize framebuffer_size() const = 0;
  // Takes what keyboard and mouse did, by the functions below, waiting at most that long [s]; 0 or less: not at all.
  virtual void take_events(double wait_s) = 0;
  // Before each of ImGui's frames: ImGuiIO's DisplaySize and DisplayFramebufferScale, and where the pointer is. The
  // time between frames is set afterwards.
  virtual void begin_imgui_frame() = 0;
  // Shows what was drawn on the framebuffer that was bound when the frame began.
  virtual void show_frame() = 0;

  // --- What a platform's window tells as it happens. Pointer, buttons and wheel it tells to ImGuiIO itself too ---

  // Something has happened to it, and the next frame may be another: poll() is true.
  void note_change() noexcept { is_stirred_ = true; }
  // Somebody has used a key, a button or the wheel. The functions for keys below say it themselves.
  void note_act() noexcept;
  // The pointer has moved.
  void note_move() noexcept;
  // A key went down, repeats or went up. `press.key` is one of keys.h by its place on a US keyboard, or another number
  // that is not 0; `printed` is what the keyboard's layout has on it, in UTF-8, null where nothing is known. Modifiers
  // are those of that moment, with or without the one that is the key itself.
  void add_key_event(KeyPress press, const char* printed, bool is_down);
  // A character was typed (Unicode): by the key that went down last, if it comes right after it, else by an input
  // method.
  void add_character(std::uint32_t character);
  // The clipboard's text is there: Ctrl+V, as if the person pressed it now.
  void add_paste();
  // The clipboard's text does not come.
  void note_clipboard_problem(std::string problem);
  // Paths of files that can be opened.
  void add_dropped_files(std::vector<std::string> paths);

 private:
  void begin_frame(double interval_s);

  Fonts fonts_{};
  int density_ = 1;  // of the frame that is being drawn
  std::deque<KeyEvent> key_events_;
  bool awaits_character_ = false;  // of the newest of them it is not known yet what it types
  std::vector<std::string> dropped_files_;
  std::string clipboard_problem_;
  bool is_stirred_ = false;  // since the last poll
  Touch touch_;              // since the last take_touch
};

// What Dear ImGui calls one of keys.h; ImGuiKey_None where it has no name for it. Pure, any thread.
ImGuiKey imgui_key(int key) noexcept;

// Windows of Dear ImGui that stand still: the whole screen, and the pieces that it is divided into. Tab goes through
// all pieces of a screen, in the order in which they are drawn.
inline constexpr ImGuiWindowFlags fixed_window =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
inline constexpr ImGuiWindowFlags fixed_bar = fixed_window | ImGuiWindowFlags_NoScrollWithMouse;

struct Rect {
  ImVec2 corner;
  ImVec2 size;
};

// Ends with ImGui::End().
inline void begin_screen(const char* name) {
  ImGui::SetNextWindowPos({0.0F, 0.0F});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::Begin(name, nullptr, fixed_bar | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar();
}

// Within a screen; ends with ImGui::EndChild(). ImGui::BeginChild() would make a name of its own for it.
inline void begin_piece(const char* name, const Rect& rect, ImGuiWindowFlags flags) {
  ImGui::SetCursorScreenPos(rect.corner);
  ImGui::SetNextWindowSize(rect.size);
  ImGuiNextWindowData& next = ImGui::GetCurrentContext()->NextWindowData;
  next.HasFlags |= ImGuiNextWindowDataFlags_HasChildFlags;
  next.ChildFlags = ImGuiChildFlags_NavFlattened | ImGuiChildFlags_AlwaysUseWindowPadding;
  ImGui::Begin(name, nullptr, flags | ImGuiWindowFlags_ChildWindow);
}

// How much of the screen a picture shows.
enum class Part : std::uint8_t {
  window,  // scene, panels and bars
  scene,   // the scene alone
};

// What painters multiply the height of a face's labels by: those of the stage are as large as they say.
inline double text_scale_of(Face face, double scale, const Theme& theme) noexcept {
  return face == Face::stage ? 1.0 : scale * theme.thickness;
}

// The key that is meant. `key` is one of keys.h by its place on a US keyboard; `name` is what the layout has on it, in
// UTF-8; null: nothing.
//
// It goes by what is printed on the key where that is a letter, bracket, dot or minus: Ctrl+Z is where the Z is.
// Otherwise by its place: the digits of a French keyboard, what no ASCII sign is printed on, and the number pad. A plus
// of its own, as at ] of German and Spanish keyboards, is key::equal.
int key_by_layout(int key, const char* name) noexcept;

// The press once it is known what it has typed, which layouts make with Shift or AltGr as they please: a plus, a minus
// or a bracket is key::equal, key::minus, key::left_bracket or key::right_bracket without Shift. Anything else stays
// the key that it is. With Ctrl or Alt nothing is typed.
KeyPress press_by_character(KeyPress press, std::uint32_t character) noexcept;

// The modifier of a key that is a modifier itself; 0: it is none.
int modifier_of(int key) noexcept;

}  // namespace ghostforce
