// The one table of keys: what is pressed, what it does, in words for the person and as a function. Help, README and
// tests walk it.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "app/session/front_keys.h"
#include "app/session/session.h"

namespace ghostforce {

// As it happened, with the modifiers of that moment. ImGui tells which keys are down once per frame; where a frame takes
// as long as a quick chord, Alt+R would be an R.
struct KeyPress {
  int key = 0;        // one of keys.h; letters, digits and signs as the keyboard's layout has them
  int modifiers = 0;  // modifier::shift | modifier::control | modifier::alt | modifier::super
  bool is_repeat = false;
};

struct KeyBinding {
  int key;                    // of keys.h
  int modifiers;              // of keys.h
  std::string_view shown;     // as printed on the keys; empty: a further key of the row above
  std::string_view sentence;  // what it does
  void (*act)(Session&);
  bool repeats = false;         // holding it down does it again
  bool also_in_fields = false;  // even while the person types into a field, where most keys are letters
  std::string_view group{};     // of this row and those that follow; empty: that of the row above
  bool for_visitors = false;    // also in the visitor's mode
  bool for_own_window = false;  // not in a page
};

// Of this front.
std::span<const KeyBinding> key_table();
// Of a front with these keys.
std::vector<KeyBinding> key_table_of(const FrontKeys& keys);

// The mouse in the scene, in words: what the gestures do.
struct MouseGesture {
  std::string_view group;  // one of the keys'
  std::string_view shown;
  std::string_view sentence;
};
std::span<const MouseGesture> mouse_table() noexcept;

// Does what the pressed key asks for. `is_typing`: the person is typing into a field.
void act_on_key(Session& session, const KeyPress& press, bool is_typing);

// True: the table has an action for that key, or it types into the field. What else acts on keys, as a browser does,
// should not act on this one too. Holding a key down that does not repeat is still ours.
bool is_ours(const KeyPress& press, bool is_typing);

// The same actions, for buttons.
void next_compare_mode(Session& session);
void toggle_pause(Session& session);
void single_step(Session& session);
// One tick back, into what has been; and on, through that to its end and then through what has not been yet.
void step_back(Session& session);
void step_on(Session& session);
// No longer looks back.
void go_on_live(Session& session);
void restart(Session& session);
void restart_with_scene_settings(Session& session);
template <Dialog which>
void open_dialog(Session& session) {
  session.dialog = session.dialog == which ? Dialog::none : which;
}

}  // namespace ghostforce
