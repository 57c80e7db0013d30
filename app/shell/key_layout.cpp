#include "app/shell/key_layout.h"

#include "app/state/keys.h"

namespace ghostforce {

int key_by_layout(int key, const char* name) noexcept {
  const bool is_on_number_pad = key >= key::number_pad_0 && key <= key::number_pad_equal;
  if (is_on_number_pad || name == nullptr || name[0] == '\0' || name[1] != '\0') return key;
  const char sign = name[0];
  if (sign >= 'a' && sign <= 'z') return key::a + (sign - 'a');
  if (sign >= 'A' && sign <= 'Z') return key::a + (sign - 'A');
  switch (sign) {
    case '.':
      return key::period;
    case ',':
      return key::comma;
    case '[':
      return key::left_bracket;
    case ']':
      return key::right_bracket;
    case '-':
      return key::minus;
    case '+':
      return key::equal;
    default:
      return key;
  }
}

KeyPress press_by_character(KeyPress press, std::uint32_t character) noexcept {
  switch (character) {
    case '+':
      press.key = key::equal;
      break;
    case '-':
    case 0x2212:  // the sign itself
      press.key = key::minus;
      break;
    case '[':
      press.key = key::left_bracket;
      break;
    case ']':
      press.key = key::right_bracket;
      break;
    default:
      return press;
  }
  press.modifiers &= ~modifier::shift;
  return press;
}

int modifier_of(int key) noexcept {
  switch (key) {
    case key::left_shift:
    case key::right_shift:
      return modifier::shift;
    case key::left_control:
    case key::right_control:
      return modifier::control;
    case key::left_alt:
    case key::right_alt:
      return modifier::alt;
    case key::left_super:
    case key::right_super:
      return modifier::super;
    default:
      return 0;
  }
}

}  // namespace ghostforce
