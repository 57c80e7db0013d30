// What becomes of the display while the window is open: DisplayWatch hears it from an X server, and the functions after
// it end the program in good order when the display is lost. UI thread, but for what says otherwise.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

#include "app/files/descriptor.h"
#include "app/shell/desktop/xcb_connection.h"

namespace ghostforce {

// What has been lost.
enum class DisplayLoss : std::uint8_t { none, window, server };

// Hears from an X server at once what becomes of a window, however long the window's own thread is busy: another client
// takes the keyboard, destroys the window, or the server ends. It has a connection and a thread of its own. GLFW tells
// none of this: it passes over keyboard grabs and destroyed windows, and Xlib tells of a server's end only whoever
// calls it.
class DisplayWatch {
 public:
  // Of that window, which nobody has focused yet. `when_lost` is called once, on the watch's thread; null: nothing is.
  // Throws Failure(no_display) if the server takes no second connection, or the window is gone.
  DisplayWatch(std::uint32_t window, void (*when_lost)() noexcept);
  ~DisplayWatch();
  DisplayWatch(const DisplayWatch&) = delete;
  DisplayWatch& operator=(const DisplayWatch&) = delete;

  // Another client has grabbed the keyboard: keys go there, whichever window has the focus. A grab that names this very
  // window for its keys is not seen: the server tells nobody of it. Any thread.
  bool keyboard_is_taken() const noexcept { return keyboard_is_taken_.load(std::memory_order_relaxed); }
  DisplayLoss loss() const noexcept { return loss_.load(std::memory_order_relaxed); }

  // Asks the server, by a connection made for it. False also where there is no server any more.
  static bool window_exists(std::uint32_t window) noexcept;

 private:
  void watch() noexcept;
  void take_events() noexcept;

  std::uint32_t window_;
  void (*when_lost_)() noexcept;
  XcbConnection connection_;
  Descriptor end_;  // something to read: the thread is to end
  std::atomic<bool> keyboard_is_taken_{false};
  std::atomic<DisplayLoss> loss_{DisplayLoss::none};
  std::thread thread_;  // last: it uses what stands above
};

// From now on the program ends when the display is lost: the server has crashed, the session has ended, or another
// client has destroyed the window. The X library lets nobody return from that, so the program ends from within, with
// words and ExitCode::no_display, once what must not be lost has been put in order. To be called once GLFW has been
// initialised, with a display.
void watch_display();

// From now on an X error counts as the end of that window if it no longer exists. 0: of none.
void expect_window(std::uint32_t window);

// Ends the program if its watch or another thread has found the loss, or, for displays whose loss only shows when they
// are asked (Wayland), if this one finds it now. Between frames.
void end_if_display_is_lost(DisplayLoss seen_by_watch);

// What is to be done before the program ends, for as long as this lives. It may not touch the window. One at a time.
class BeforeDisplayLoss {
 public:
  explicit BeforeDisplayLoss(std::function<void()> put_in_order);
  ~BeforeDisplayLoss();
  BeforeDisplayLoss(const BeforeDisplayLoss&) = delete;
  BeforeDisplayLoss& operator=(const BeforeDisplayLoss&) = delete;
};

}  // namespace ghostforce
