// A key press as it happened, with the modifiers of that moment. ImGui tells which keys are down once per frame; where
// a frame takes as long as a quick chord, Alt+R would be an R.
#pragma once

namespace ghostforce {

struct KeyPress {
  int key = 0;        // GLFW_KEY_…; letters, digits and signs as the keyboard's layout has them
  int modifiers = 0;  // GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER
  bool is_repeat = false;
};

}  // namespace ghostforce
