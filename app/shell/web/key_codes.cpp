#include "app/shell/web/key_codes.h"

#include <algorithm>
#include <array>

#include "app/state/keys.h"

namespace ghostforce {
namespace {

struct CodeEntry {
  std::string_view code;
  int key;
};

constexpr std::array codes{
    CodeEntry{"Space", key::space},
    CodeEntry{"Quote", key::apostrophe},
    CodeEntry{"Comma", key::comma},
    CodeEntry{"Minus", key::minus},
    CodeEntry{"Period", key::period},
    CodeEntry{"Slash", key::slash},
    CodeEntry{"Semicolon", key::semicolon},
    CodeEntry{"Equal", key::equal},
    CodeEntry{"BracketLeft", key::left_bracket},
    CodeEntry{"Backslash", key::backslash},
    CodeEntry{"BracketRight", key::right_bracket},
    CodeEntry{"Backquote", key::grave_accent},
    CodeEntry{"IntlBackslash", key::world_1},
    CodeEntry{"Escape", key::escape},
    CodeEntry{"Enter", key::enter},
    CodeEntry{"Tab", key::tab},
    CodeEntry{"Backspace", key::backspace},
    CodeEntry{"Insert", key::insert},
    CodeEntry{"Delete", key::delete_forward},
    CodeEntry{"ArrowRight", key::right},
    CodeEntry{"ArrowLeft", key::left},
    CodeEntry{"ArrowDown", key::down},
    CodeEntry{"ArrowUp", key::up},
    CodeEntry{"PageUp", key::page_up},
    CodeEntry{"PageDown", key::page_down},
    CodeEntry{"Home", key::home},
    CodeEntry{"End", key::end},
    CodeEntry{"CapsLock", key::caps_lock},
    CodeEntry{"ScrollLock", key::scroll_lock},
    CodeEntry{"NumLock", key::number_lock},
    CodeEntry{"PrintScreen", key::print_screen},
    CodeEntry{"Pause", key::pause},
    CodeEntry{"F1", key::f1},
    CodeEntry{"F2", key::f2},
    CodeEntry{"F3", key::f3},
    CodeEntry{"F4", key::f4},
    CodeEntry{"F5", key::f5},
    CodeEntry{"F6", key::f6},
    CodeEntry{"F7", key::f7},
    CodeEntry{"F8", key::f8},
    CodeEntry{"F9", key::f9},
    CodeEntry{"F10", key::f10},
    CodeEntry{"F11", key::f11},
    CodeEntry{"F12", key::f12},
    CodeEntry{"NumpadDecimal", key::number_pad_decimal},
    CodeEntry{"NumpadDivide", key::number_pad_divide},
    CodeEntry{"NumpadMultiply", key::number_pad_multiply},
    CodeEntry{"NumpadSubtract", key::number_pad_subtract},
    CodeEntry{"NumpadAdd", key::number_pad_add},
    CodeEntry{"NumpadEnter", key::number_pad_enter},
    CodeEntry{"NumpadEqual", key::number_pad_equal},
    CodeEntry{"ShiftLeft", key::left_shift},
    CodeEntry{"ControlLeft", key::left_control},
    CodeEntry{"AltLeft", key::left_alt},
    CodeEntry{"MetaLeft", key::left_super},
    CodeEntry{"ShiftRight", key::right_shift},
    CodeEntry{"ControlRight", key::right_control},
    CodeEntry{"AltRight", key::right_alt},
    CodeEntry{"MetaRight", key::right_super},
    CodeEntry{"ContextMenu", key::menu},
};

// KeyA, Digit7, Numpad7: the last letter of a code that is nothing else.
bool is_between(std::string_view code, std::string_view begins, char first, char last) noexcept {
  return code.size() == begins.size() + 1 && code.starts_with(begins) && code.back() >= first && code.back() <= last;
}

}  // namespace

int key_of_code(std::string_view code) noexcept {
  if (is_between(code, "Key", 'A', 'Z')) return key::a + (code.back() - 'A');
  if (is_between(code, "Digit", '0', '9')) return key::digit_0 + (code.back() - '0');
  if (is_between(code, "Numpad", '0', '9')) return key::number_pad_0 + (code.back() - '0');
  const auto entry = std::ranges::find(codes, code, &CodeEntry::code);
  return entry != codes.end() ? entry->key : 0;
}

}  // namespace ghostforce
