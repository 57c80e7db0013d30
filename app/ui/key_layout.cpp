#include "app/ui/key_layout.h"

#include <GLFW/glfw3.h>

namespace ghostforce {

int key_by_layout(int key, const char* name) noexcept {
  const bool is_on_number_pad = key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_EQUAL;
  if (is_on_number_pad || name == nullptr || name[0] == '\0' || name[1] != '\0') return key;
  const char sign = name[0];
  if (sign >= 'a' && sign <= 'z') return GLFW_KEY_A + (sign - 'a');
  if (sign >= 'A' && sign <= 'Z') return GLFW_KEY_A + (sign - 'A');
  switch (sign) {
    case '.':
      return GLFW_KEY_PERIOD;
    case ',':
      return GLFW_KEY_COMMA;
    case '[':
      return GLFW_KEY_LEFT_BRACKET;
    case ']':
      return GLFW_KEY_RIGHT_BRACKET;
    case '-':
      return GLFW_KEY_MINUS;
    case '+':
      return GLFW_KEY_EQUAL;
    default:
      return key;
  }
}

KeyPress press_by_character(KeyPress press, std::uint32_t character) noexcept {
  switch (character) {
    case '+':
      press.key = GLFW_KEY_EQUAL;
      break;
    case '-':
    case 0x2212:  // the sign itself
      press.key = GLFW_KEY_MINUS;
      break;
    case '[':
      press.key = GLFW_KEY_LEFT_BRACKET;
      break;
    case ']':
      press.key = GLFW_KEY_RIGHT_BRACKET;
      break;
    default:
      return press;
  }
  press.modifiers &= ~GLFW_MOD_SHIFT;
  return press;
}

int modifier_of(int key) noexcept {
  switch (key) {
    case GLFW_KEY_LEFT_SHIFT:
    case GLFW_KEY_RIGHT_SHIFT:
      return GLFW_MOD_SHIFT;
    case GLFW_KEY_LEFT_CONTROL:
    case GLFW_KEY_RIGHT_CONTROL:
      return GLFW_MOD_CONTROL;
    case GLFW_KEY_LEFT_ALT:
    case GLFW_KEY_RIGHT_ALT:
      return GLFW_MOD_ALT;
    case GLFW_KEY_LEFT_SUPER:
    case GLFW_KEY_RIGHT_SUPER:
      return GLFW_MOD_SUPER;
    default:
      return 0;
  }
}

}  // namespace ghostforce
