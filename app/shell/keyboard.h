// Keyboard: hands each key press to whom it is for: a field that somebody types into, the control that has the focus,
// or the table of keys. One after another, so that many presses before a slow frame do the same as each before a frame
// of its own: what a press has asked for is done before the next one is looked at, and a press that changes who gets
// the next one makes that wait until the screen has followed. Between frames, UI thread.
#pragma once

#include <cstdint>

#include "app/shell/window.h"
#include "app/state/action.h"
#include "app/state/key_bindings.h"

namespace ghostforce {

class Keyboard {
 public:
  // `apply` does at once what a press asks for, and the session shows it.
  void take(Window& window, const Session& session, const ActionSink& apply);

  // A key was pressed before the last take().
  bool has_pressed() const noexcept { return has_pressed_; }
  // Some presses have not been taken yet: a further frame is due.
  static bool is_waiting(Window& window);

 private:
  void act(const KeyEvent& event, const Session& session, const ActionSink& apply);
  void act_on_table(const KeyPress& press, const Session& session, bool is_typing, const ActionSink& apply);
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
