// Keyboard: hands each key press to whom it is for: a field that somebody types into, the control that has the focus, or
// the table of keys. One after another, so that many presses before a slow frame do the same as each before a frame of
// its own: what a press has asked for is done before the next one is looked at, and a press that changes who gets the
// next one makes that wait until the screen has followed. Between frames, UI thread.
#pragma once

#include <cstdint>
#include <functional>

#include "app/session/session.h"
#include "app/ui/window.h"

namespace ghostforce {

class Keyboard {
 public:
  // `do_what_is_asked` does what a press has left in session.requests.
  void take(Window& window, Session& session, const std::function<void()>& do_what_is_asked);

  // A key was pressed before the last take().
  bool has_pressed() const noexcept { return has_pressed_; }
  // Some presses have not been taken yet: a further frame is due.
  static bool is_waiting(Window& window);

 private:
  void act(const KeyEvent& event, Session& session, const std::function<void()>& do_what_is_asked);
  void act_on_table(const KeyPress& press, Session& session, bool is_typing,
                    const std::function<void()>& do_what_is_asked);
  void follow_windows(const Session& session);
  void wait(int frames);

  int frames_to_wait_ = 0;
  bool has_pressed_ = false;
  bool had_focus_ = false;  // when the dialog was opened
  Dialog dialog_ = Dialog::none;
  Face face_ = Face::workbench;
  std::uint32_t departures_ = 0;  // of visitors
};

}  // namespace ghostforce
