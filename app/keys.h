// The one table of keys: what is pressed, what it does, in words for the person and as a function. The window asks it
// every frame; help and tests walk it.
#pragma once

#include <span>
#include <string_view>

#include <imgui.h>

#include "app/session.h"

namespace ghostforce {

struct KeyBinding {
  ImGuiKeyChord chord;
  std::string_view shown;     // as printed on the key
  std::string_view sentence;  // what it does
  void (*act)(Session&);
  bool repeats;  // holding it down does it again
};

std::span<const KeyBinding> key_table() noexcept;

// Does what the pressed keys ask for, unless the person is typing into a field.
void act_on_keys(Session& session);

// The same actions, for buttons.
void toggle_compare(Session& session);
void toggle_pause(Session& session);
void single_step(Session& session);
void restart(Session& session);
void restart_with_scene_settings(Session& session);

}  // namespace ghostforce
