#include "app/state/key_bindings.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/state/keys.h"

namespace ghostforce {
namespace {

// Millimetres in steps of a tenth.
Action move_hand(int x, int y, int tenths) {
  return MoveHandBy{0.0001 * tenths * Vector<2>(x, y)};
}

// In thousandths; as many steps up as down lead back.
Action turn_ratio_by(int thousandths) {
  const double step = 1.0 + 0.001 * std::abs(thousandths);
  return TurnRatio{thousandths > 0 ? step : 1.0 / step};
}

// What is seen goes the other way.
Action move_picture(int x, int y) {
  return PanView{-0.05 * Vector<2>(x, y)};
}

// A page has no such key.
KeyBinding for_own_window(KeyBinding binding) {
  binding.for_own_window = true;
  return binding;
}

// With one of these nothing is typed.
constexpr int chords = modifier::control | modifier::alt | modifier::super;

// Into a field it types a letter or another sign.
constexpr bool types_a_sign(int key, int modifiers) {
  return key < key::escape && (modifiers & chords) == 0;
}

// What is typed, and the keys that move and delete without a chord. Function keys do nothing there.
bool is_for_field(const KeyPress& press) {
  const bool is_function_key = press.key >= key::f1 && press.key <= key::f24;
  return !is_function_key && (press.modifiers & chords) == 0;
}

// What the palette has too; a row for one key is called the same there.
KeyBinding called(ActionWords words, KeyBinding binding) {
  binding.named = words;
  if (!binding.shown.empty() && binding.sentence.empty()) binding.sentence = (english_stage.actions.*words).words;
  return binding;
}

// With a key that may be another in another front. `also_in_fields`: but where it is a letter there.
KeyBinding bound(const FrontKey& at, ActionWords words, const Action& action, bool also_in_fields = false) {
  return called(words, {.key = at.key,
                        .modifiers = at.modifiers,
                        .shown = {},
                        .sentence = {},
                        .action = action,
                        .also_in_fields = also_in_fields && !types_a_sign(at.key, at.modifiers)});
}

// The first key of a row that has several; the others follow.
KeyBinding row_of(std::string_view keys, std::string_view sentence, KeyBinding first, std::string_view group = {}) {
  first.shown = keys;
  first.sentence = sentence.empty() ? (english_stage.actions.*first.named).words : sentence;
  first.group = group;
  return first;
}

std::string both(const FrontKey& first, const FrontKey& second) {
  return fmt::format("{}, {}", first.shown, second.shown);
}

constexpr int none = 0;
constexpr int shift = modifier::shift;
constexpr int ctrl = modifier::control;
constexpr int alt = modifier::alt;

constexpr FrontKey palette{key::p, ctrl, "Ctrl+P"};
constexpr FrontKey switch_face{key::f4, none, "F4"};

struct Arrow {
  int key;
  int x;
  int y;
};
constexpr std::array arrows{Arrow{key::left, -1, 0}, Arrow{key::right, 1, 0}, Arrow{key::up, 0, 1},
                            Arrow{key::down, 0, -1}};

// clang-format off
constexpr std::array gestures{
    MouseGesture{"Move and change", "Drag", "Move the goal of your hand"},
    MouseGesture{"Move and change", "Drag rail or grip", "Turn the motor or the wall by 5° (Ctrl: freely)"},
    MouseGesture{"View", "Wheel, right drag", "Zoom at the pointer; move the view"},
    MouseGesture{"Move and change", "Ctrl+click a slider", "Type a number"},
};
// clang-format on

}  // namespace

std::vector<KeyBinding> key_table_of(const FrontKeys& keys) {
  using Name = StageLanguage::Actions;
  std::vector<KeyBinding> bindings;
  for (const auto& [key, x, y] : arrows) {
    bindings.push_back({key, none, "", "", move_hand(x, y, 10), true});
    bindings.push_back({key, shift, "", "", move_hand(x, y, 1), true});
    bindings.push_back({key, ctrl, "", "", move_hand(x, y, 100), true});
    bindings.push_back({key, keys.move_view_modifiers, "", "", move_picture(x, y), true});
  }
  bindings.front() =
      row_of("Arrows", "Move goal or guess 1 mm (Shift: 0.1, Ctrl: 10)", bindings.front(), "Move and change");
  // clang-format off
  bindings.insert(bindings.end(), {
    called(&Name::turn_motor_left, {key::left_bracket, none, "[  ]", "Turn the actuated direction 5° (Shift: 1°)", TurnMotorBy{5}, true}),
    called(&Name::turn_motor_right, {key::right_bracket, none, "", "", TurnMotorBy{-5}, true}),
    KeyBinding{key::left_bracket, shift, "", "", TurnMotorBy{1}, true},
    KeyBinding{key::right_bracket, shift, "", "", TurnMotorBy{-1}, true},
    called(&Name::lower_ratio, {key::minus, none, "−  +", "Lower or raise the ratio ρ by 5 % (Alt: 1 %)", turn_ratio_by(-50), true}),
    called(&Name::raise_ratio, {key::equal, none, "", "", turn_ratio_by(50), true}),
    KeyBinding{key::minus, alt, "", "", turn_ratio_by(-10), true},
    KeyBinding{key::equal, alt, "", "", turn_ratio_by(10), true},
    KeyBinding{key::equal, alt | shift, "", "", turn_ratio_by(10), true},

    KeyBinding{key::digit_1, none, "1 2 3", "Fully actuated, naïve, anisotropic (Shift: slowly)", ChooseByNumber{StrategyId::full}, false, false, "Strategies"},
    KeyBinding{key::digit_2, none, "", "", ChooseByNumber{StrategyId::naive}},
    KeyBinding{key::digit_3, none, "", "", ChooseByNumber{StrategyId::anisotropic}},
    KeyBinding{key::digit_1, shift, "", "", ChooseStrategy{StrategyId::full, true}},
    KeyBinding{key::digit_2, shift, "", "", ChooseStrategy{StrategyId::naive, true}},
    KeyBinding{key::digit_3, shift, "", "", ChooseStrategy{StrategyId::anisotropic, true}},

    called(&Name::pause, {key::space, none, "Space", {}, TogglePause{}, false, false, "Time"}),
    called(&Name::step_back, {key::comma, none, ", .", "Pause; one tick back or forward, up to a minute", StepBack{}, true}),
    called(&Name::step_on, {key::period, none, "", "", StepOn{}, true}),
    called(&Name::restart, {key::r, none, "R, Alt+R", "Reset the motion (Alt: and all settings)", Restart{}}),
    called(&Name::restart_with_settings, {key::r, alt, "", "", Restart{true}}),

    called(&Name::fit_view, {key::f, none, "F, Z", keys.view_sentence, FitView{}, false, false, "View"}),
    called(&Name::zoom_in, {key::z, none, "", "", ZoomView{1.25}, true}),
    called(&Name::zoom_out, {key::z, shift, "", "", ZoomView{0.8}, true}),

    KeyBinding{key::q, none, "Q Y L", "Predict, Why?, Landscape", ToggleMode{StageMode::predict}, false, false, "Stage"},
    KeyBinding{key::y, none, "", "", ToggleMode{StageMode::why}},
    KeyBinding{key::l, none, "", "", ToggleMode{StageMode::landscape}},
    KeyBinding{key::o, none, "O H S", "Round and round, Last minute, Measure the hand", ToggleMode{StageMode::round}},
    KeyBinding{key::h, none, "", "", ToggleMode{StageMode::ribbon}},
    KeyBinding{key::s, none, "", "", MeasureHand{}},
    KeyBinding{key::enter, none, "Enter", "Next step of a lesson or of Why?; answer a guess", Confirm{}},
    row_of(keys.lessons.shown, {}, bound(keys.lessons, &Name::lessons, ToggleDialog{Dialog::lessons}, true)),
    called(&Name::next_step, {key::page_down, none, "PgDn PgUp", "Lesson or talk: next / previous step", NextStep{}}),
    called(&Name::previous_step, {key::page_up, none, "", "", PreviousStep{}}),
    called(&Name::blank, {key::b, none, "B A", "Blank the stage; hide its numbers", ToggleBlank{}}),
    called(&Name::numbers, {key::a, none, "", "", ToggleNumbers{}}),

    KeyBinding{key::escape, none, "Esc", "Motors off; then close what is open (never quits)", Escape{}, false, true, "Device"},
    row_of(keys.device_status.shown, {}, bound(keys.device_status, &Name::device_status, ToggleDialog{Dialog::doctor}, true)),

    called(&Name::undo, {key::z, ctrl, "Ctrl+Z, Ctrl+Y", "Undo, redo (also Ctrl+Shift+Z)", Undo{}, true, false, "Undo, files, clipboard"}),
    called(&Name::redo, {key::z, ctrl | shift, "", "", Redo{}, true}),
    KeyBinding{key::y, ctrl, "", "", Redo{}, true},
    called(&Name::copy_set_up, {key::c, ctrl, "Ctrl+C, Ctrl+V", "Copy what is shown as a command; paste one", CopySetUp{}}),
    called(&Name::paste_set_up, {key::v, ctrl, "", "", PasteSetUp{}}),
    row_of(keys.link.shown, {}, bound(keys.link, &Name::link, ShowLink{})),
    called(&Name::open_scene, {key::o, ctrl, "Ctrl+O, Ctrl+S", "Open a scene (or drop a file); save it", ToggleDialog{Dialog::open_scene}, false, true}),
    called(&Name::save_scene, {key::s, ctrl, "", "", ToggleDialog{Dialog::save_scene}, false, true}),
    row_of(keys.pictures, "Save or copy a picture; copy the live values", bound(keys.save_picture, &Name::save_picture, ToggleDialog{Dialog::save_picture}, true)),
    bound(keys.copy_picture, &Name::copy_picture, CopyPicture{}),
    bound(keys.copy_values, &Name::copy_values, CopyValues{}, true),

    row_of(both(keys.help, palette), "Help: all keys; every action by its words", bound(keys.help, &Name::help, ToggleDialog{Dialog::help}, true), "Window"),
    KeyBinding{palette.key, palette.modifiers, "", "", ToggleDialog{Dialog::palette}, false, true},
    row_of(both(switch_face, keys.plots), "Stage or workbench; plots", bound(switch_face, &Name::switch_face, SwitchFace{}, true)),
    bound(keys.plots, &Name::plots, TogglePlots{}, true),
    row_of(both(keys.full_screen, keys.next_theme), "Full screen; next theme: light, dark, projector", bound(keys.full_screen, &Name::full_screen, ToggleFullScreen{}, true)),
    bound(keys.next_theme, &Name::next_theme, NextTheme{}),
    for_own_window(called(&Name::larger_text, {key::equal, ctrl, "Ctrl+ + − 0", "Text size: larger, smaller, default", ChangeTextSize{1}, true})),
    for_own_window({key::equal, ctrl | shift, "", "", ChangeTextSize{1}, true}),
    for_own_window(called(&Name::smaller_text, {key::minus, ctrl, "", "", ChangeTextSize{-1}, true})),
    for_own_window(called(&Name::usual_text, {key::digit_0, ctrl, "", "", UseUsualTextSize{}})),
    KeyBinding{key::tab, none, "Tab", "Next control (Shift: previous)", std::nullopt, true},
    KeyBinding{key::tab, shift, "", "", std::nullopt, true},
    for_own_window(called(&Name::quit, {key::q, ctrl, "Ctrl+Q", {}, Quit{}, false, true})),
    for_own_window({key::q, ctrl | alt | shift, "", "", Quit{.ends_visit = true}, false, true}),  // told on the terminal
  });
  // clang-format on
  std::erase_if(bindings, [&](const KeyBinding& binding) {
    return binding.key == 0 || (binding.for_own_window && !keys.has_own_window);
  });
  return bindings;
}

std::string chord_of(const KeyBinding& binding) {
  struct KeyName {
    int key;
    std::string_view name;
  };
  constexpr std::array names{KeyName{key::space, "Space"},  KeyName{key::minus, "−"},       KeyName{key::equal, "+"},
                             KeyName{key::enter, "Enter"},  KeyName{key::escape, "Esc"},    KeyName{key::tab, "Tab"},
                             KeyName{key::page_up, "PgUp"}, KeyName{key::page_down, "PgDn"}};
  std::string chord;
  if ((binding.modifiers & ctrl) != 0) chord += "Ctrl+";
  if ((binding.modifiers & alt) != 0) chord += "Alt+";
  if ((binding.modifiers & shift) != 0) chord += "Shift+";
  const auto named = std::ranges::find(names, binding.key, &KeyName::key);
  if (named != names.end()) return chord.append(named->name);
  if (binding.key >= key::f1 && binding.key <= key::f12) return chord + 'F' + std::to_string(binding.key - key::f1 + 1);
  return chord + static_cast<char>(binding.key);
}

std::span<const KeyBinding> key_table() {
  static const std::vector<KeyBinding> table = key_table_of(front_keys());
  return table;
}

std::span<const MouseGesture> mouse_table() noexcept {
  return gestures;
}

namespace {

// The number pad types the same signs, and has another Enter.
int main_key(int key) {
  if (key == key::number_pad_add) return key::equal;
  if (key == key::number_pad_subtract) return key::minus;
  return key == key::number_pad_enter ? key::enter : key;
}

const KeyBinding* binding_of(const KeyPress& press, bool is_typing) {
  const auto found = std::ranges::find_if(key_table(), [&](const KeyBinding& binding) {
    return binding.key == main_key(press.key) && binding.modifiers == press.modifiers &&
           (!is_typing || binding.also_in_fields);
  });
  return found == key_table().end() ? nullptr : &*found;
}

}  // namespace

std::optional<Action> action_of_key(const KeyPress& press, bool is_typing) {
  const KeyBinding* const binding = binding_of(press, is_typing);
  if (binding == nullptr || (press.is_repeat && !binding->repeats)) return std::nullopt;
  return binding->action;
}

bool is_ours(const KeyPress& press, bool is_typing) {
  return (is_typing && is_for_field(press)) || binding_of(press, is_typing) != nullptr;
}

}  // namespace ghostforce
