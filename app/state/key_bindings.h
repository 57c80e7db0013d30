// The one table of keys: what is pressed, what it does, in words for the person and as an action. Help, docs/keys.md and
// tests walk it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/state/action.h"
#include "app/state/front_keys.h"
#include "app/state/stage_language.h"

namespace ghostforce {

// As it happened, with the modifiers of that moment. ImGui tells which keys are down once per frame; where a frame
// takes as long as a quick chord, Alt+R would be an R.
struct KeyPress {
  int key = 0;        // one of keys.h; letters, digits and signs as the keyboard's layout has them
  int modifiers = 0;  // modifier::shift | modifier::control | modifier::alt | modifier::super
  bool is_repeat = false;
};

// What an action is called, in each language.
using ActionWords = StageLanguage::Action StageLanguage::Actions::*;
// What a row of keys does that no single action's words say.
using KeyRowWords = std::string_view StageLanguage::KeyRows::*;

struct KeyBinding {
  int key;                       // of keys.h
  int modifiers;                 // of keys.h
  std::string shown;             // as printed on the keys; empty: a further key of the row above
  std::string_view sentence;     // what it does, in English
  std::optional<Action> action;  // empty: the screen moves the focus
  bool repeats = false;          // holding it down does it again
  bool also_in_fields = false;   // even while the person types into a field, where most keys are letters
  std::string_view group{};      // in English; of this row and those that follow; empty: that of the row above
  bool for_own_window = false;   // not in a page
  ActionWords named = nullptr;   // as the palette has it; null: it is not there, or under other words
  KeyRowWords row = nullptr;     // null: the row says what its action is called
};

// What that row does; empty where it is not shown.
std::string_view sentence_in(const StageLanguage& language, const KeyBinding& binding) noexcept;

// "Ctrl+Shift+Z": of that row alone.
std::string chord_of(const KeyBinding& binding);

// Of this front.
std::span<const KeyBinding> key_table();
// Of a front with these keys.
std::vector<KeyBinding> key_table_of(const FrontKeys& keys);

// The mouse in the scene, in words: what the gestures do, in English.
struct MouseGesture {
  std::string_view group;  // one of the keys'
  std::string_view shown;
  std::string_view sentence;
};
std::span<const MouseGesture> mouse_table() noexcept;

// What the pressed key asks for; empty: nothing. `is_typing`: the person is typing into a field.
std::optional<Action> action_of_key(const KeyPress& press, bool is_typing);

// True: the table has an action for that key, or it types into the field. What else acts on keys, as a browser does,
// should not act on this one too. Holding a key down that does not repeat is still ours.
bool is_ours(const KeyPress& press, bool is_typing);

}  // namespace ghostforce
