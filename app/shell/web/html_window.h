// The page's window: a canvas with WebGL 2 that fills the browser's tab, and what is done there with keyboard, mouse,
// pen and fingers. The browser calls; there is one at a time.
#pragma once

#include <cstdint>
#include <string_view>

#include "app/shell/web/touch_gestures.h"
#include "app/shell/window.h"

namespace ghostforce {

class HtmlWindow final : public Window {
 public:
  // On the page's canvas. Throws Failure(no_display): the browser has no WebGL 2.
  HtmlWindow();
  ~HtmlWindow() override;

  // The browser may take WebGL away, and it comes back by itself. Meanwhile nothing can be drawn; afterwards all that
  // was made with it must be made anew, which is asked for once.
  bool can_draw() const noexcept { return !is_lost_; }
  bool take_restored() noexcept;
  int context_losses() const noexcept { return context_losses_; }
  // Two fingers have moved the view since the last call, and have been lifted.
  bool take_end_of_pinch() noexcept { return touches_.take_end_of_two(); }

  // Which keys the picture has a use for. Those that it has none for lead away from it: Tab to the page's next element,
  // and Escape to no element at all.
  struct KeyUses {
    bool tab = false;
    bool escape = false;
  };
  void set_key_uses(const KeyUses& uses) noexcept { key_uses_ = uses; }

  // A tab belongs to the browser: it closes, moves and resizes it.
  bool should_close() const override { return false; }
  void close() override {}
  void stay_open() override {}
  void set_title(const std::string& title) override;
  void resize(int /*width*/, int /*height*/) override {}
  bool is_maximized() const override { return false; }
  void maximize() override {}
  void restore(int /*width*/, int /*height*/) override {}
  WindowSize restored_size() const override { return size_; }

  float display_scale() const override { return 1.0F; }  // ImGui draws denser by itself
  void toggle_full_screen() override;
  bool is_full_screen() const override;
  bool has_focus() const override;
  void set_clipboard_text(const std::string& text) override;
  std::optional<std::string> clipboard_text() override;
  DisplayKind display_kind() const override { return DisplayKind::none; }

 protected:
  WindowSize framebuffer_size() const override { return pixels_; }
  void take_events(double wait_s) override;
  void begin_imgui_frame() override;
  void show_frame() override {}  // the browser does when the frame's function returns

 private:
  struct Events;
  void listen();
  bool uses_tab() const;
  bool uses_escape() const;

  std::uintptr_t context_ = 0;
  WindowSize size_;    // of the canvas [CSS pixels]
  WindowSize pixels_;  // [px]
  TouchGestures touches_;
  KeyUses key_uses_;
  bool is_lost_ = false;
  bool is_restored_ = false;
  int context_losses_ = 0;
};

// The browser's name of a key, KeyboardEvent.code, which is its place on a US keyboard, as one of app/state/keys.h; 0:
// it is none of them.
int key_of_code(std::string_view code) noexcept;

}  // namespace ghostforce
