#include "app/shell/imgui_keys.h"

#include <array>

#include "app/state/keys.h"

namespace ghostforce {
namespace {

// Keys that stand in both lists one after another.
struct KeyRow {
  int first, last;
  ImGuiKey first_of_imgui;
};
constexpr std::array key_rows{
    KeyRow{key::digit_0, key::digit_9, ImGuiKey_0},
    KeyRow{key::a, key::z, ImGuiKey_A},
    KeyRow{key::f1, key::f24, ImGuiKey_F1},
    KeyRow{key::number_pad_0, key::number_pad_9, ImGuiKey_Keypad0},
};

}  // namespace

ImGuiKey imgui_key(int key) noexcept {
  for (const KeyRow& row : key_rows) {
    if (key >= row.first && key <= row.last) return static_cast<ImGuiKey>(row.first_of_imgui + (key - row.first));
  }
  switch (key) {
    case key::space:
      return ImGuiKey_Space;
    case key::apostrophe:
      return ImGuiKey_Apostrophe;
    case key::comma:
      return ImGuiKey_Comma;
    case key::minus:
      return ImGuiKey_Minus;
    case key::period:
      return ImGuiKey_Period;
    case key::slash:
      return ImGuiKey_Slash;
    case key::semicolon:
      return ImGuiKey_Semicolon;
    case key::equal:
      return ImGuiKey_Equal;
    case key::left_bracket:
      return ImGuiKey_LeftBracket;
    case key::backslash:
      return ImGuiKey_Backslash;
    case key::right_bracket:
      return ImGuiKey_RightBracket;
    case key::grave_accent:
      return ImGuiKey_GraveAccent;
    case key::world_1:
      return ImGuiKey_Oem102;
    case key::world_2:
      return ImGuiKey_Oem102;
    case key::escape:
      return ImGuiKey_Escape;
    case key::enter:
      return ImGuiKey_Enter;
    case key::tab:
      return ImGuiKey_Tab;
    case key::backspace:
      return ImGuiKey_Backspace;
    case key::insert:
      return ImGuiKey_Insert;
    case key::delete_forward:
      return ImGuiKey_Delete;
    case key::right:
      return ImGuiKey_RightArrow;
    case key::left:
      return ImGuiKey_LeftArrow;
    case key::down:
      return ImGuiKey_DownArrow;
    case key::up:
      return ImGuiKey_UpArrow;
    case key::page_up:
      return ImGuiKey_PageUp;
    case key::page_down:
      return ImGuiKey_PageDown;
    case key::home:
      return ImGuiKey_Home;
    case key::end:
      return ImGuiKey_End;
    case key::caps_lock:
      return ImGuiKey_CapsLock;
    case key::scroll_lock:
      return ImGuiKey_ScrollLock;
    case key::number_lock:
      return ImGuiKey_NumLock;
    case key::print_screen:
      return ImGuiKey_PrintScreen;
    case key::pause:
      return ImGuiKey_Pause;
    case key::number_pad_decimal:
      return ImGuiKey_KeypadDecimal;
    case key::number_pad_divide:
      return ImGuiKey_KeypadDivide;
    case key::number_pad_multiply:
      return ImGuiKey_KeypadMultiply;
    case key::number_pad_subtract:
      return ImGuiKey_KeypadSubtract;
    case key::number_pad_add:
      return ImGuiKey_KeypadAdd;
    case key::number_pad_enter:
      return ImGuiKey_KeypadEnter;
    case key::number_pad_equal:
      return ImGuiKey_KeypadEqual;
    case key::left_shift:
      return ImGuiKey_LeftShift;
    case key::left_control:
      return ImGuiKey_LeftCtrl;
    case key::left_alt:
      return ImGuiKey_LeftAlt;
    case key::left_super:
      return ImGuiKey_LeftSuper;
    case key::right_shift:
      return ImGuiKey_RightShift;
    case key::right_control:
      return ImGuiKey_RightCtrl;
    case key::right_alt:
      return ImGuiKey_RightAlt;
    case key::right_super:
      return ImGuiKey_RightSuper;
    case key::menu:
      return ImGuiKey_Menu;
    default:
      return ImGuiKey_None;
  }
}

}  // namespace ghostforce
