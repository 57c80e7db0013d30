// The display goes away while the window is open: the server has crashed, the session has ended, or another client has
// destroyed the window. The X library lets nobody return from that, so the program ends from within, with words and
// ExitCode::no_display, once what must not be lost has been put in order. UI thread.
#pragma once

#include <cstdint>
#include <functional>

#include "app/shell/desktop/display_watch.h"

namespace ghostforce {

// From now on. Once GLFW has been initialised, with a display.
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
