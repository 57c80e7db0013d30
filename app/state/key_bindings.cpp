#include "app/state/key_bindings.h"

#include <algorithm>
#include <array>
#include <cstdlib>

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
  if (!binding.shown.empty()) binding.sentence = sentence_in(english_stage, binding);
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

// What no single action's words say.
KeyBinding said(KeyRowWords row, KeyBinding binding) {
  binding.row = row;
  binding.sentence = sentence_in(english_stage, binding);
  return binding;
}

// The first key of a row that has several; the others follow. Without words of its own it is called as its action.
KeyBinding row_of(std::string_view keys, KeyRowWords row, KeyBinding first, std::string_view group = {}) {
  first.shown = keys;
  first.group = group;
  return said(row, std::move(first));
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

}  // namespace

std::vector<KeyBinding> key_table_of(const FrontKeys& keys) {
  using Name = StageLanguage::Actions;
  using Row = StageLanguage::KeyRows;
  const StageLanguage::KeyGroups& group = english_stage.key_groups;
  std::vector<KeyBinding> bindings;
  for (const auto& [key, x, y] : arrows) {
    bindings.push_back({key, none, "", "", move_hand(x, y, 10), true});
    bindings.push_back({key, shift, "", "", move_hand(x, y, 1), true});
    bindings.push_back({key, ctrl, "", "", move_hand(x, y, 100), true});
    bindings.push_back({key, keys.move_view_modifiers, "", "", move_picture(x, y), true});
  }
  bindings.front() = row_of("Arrows", &Row::move, bindings.front(), group.change);
  // clang-format off
  bindings.insert(bindings.end(), {
    called(&Name::turn_motor_left, said(&Row::turn_motor, {key::left_bracket, none, "[  ]", {}, TurnMotorBy{5}, true})),
    called(&Name::turn_motor_right, {key::right_bracket, none, "", "", TurnMotorBy{-5}, true}),
    KeyBinding{key::left_bracket, shift, "", "", TurnMotorBy{1}, true},
    KeyBinding{key::right_bracket, shift, "", "", TurnMotorBy{-1}, true},
    called(&Name::lower_ratio, said(&Row::turn_ratio, {key::minus, none, "−  +", {}, turn_ratio_by(-50), true})),
    called(&Name::raise_ratio, {key::equal, none, "", "", turn_ratio_by(50), true}),
    KeyBinding{key::minus, alt, "", "", turn_ratio_by(-10), true},
    KeyBinding{key::equal, alt, "", "", turn_ratio_by(10), true},
    KeyBinding{key::equal, alt | shift, "", "", turn_ratio_by(10), true},

    said(&Row::strategies, {key::digit_1, none, "1 2 3", {}, ChooseByNumber{StrategyId::full}, false, false, group.strategies}),
    KeyBinding{key::digit_2, none, "", "", ChooseByNumber{StrategyId::naive}},
    KeyBinding{key::digit_3, none, "", "", ChooseByNumber{StrategyId::anisotropic}},
    KeyBinding{key::digit_1, shift, "", "", ChooseStrategy{StrategyId::full, true}},
    KeyBinding{key::digit_2, shift, "", "", ChooseStrategy{StrategyId::naive, true}},
    KeyBinding{key::digit_3, shift, "", "", ChooseStrategy{StrategyId::anisotropic, true}},

    called(&Name::pause, {key::space, none, "Space", {}, TogglePause{}, false, false, group.time}),
    called(&Name::step_back, said(&Row::step, {key::comma, none, ", .", {}, StepBack{}, true})),
    called(&Name::step_on, {key::period, none, "", "", StepOn{}, true}),
    called(&Name::restart, said(&Row::reset, {key::r, none, "R, Alt+R", {}, Restart{}})),
    called(&Name::restart_with_settings, {key::r, alt, "", "", Restart{true}}),

    called(&Name::fit_view, said(keys.has_own_window ? &Row::view : &Row::view_in_page, {key::f, none, "F, Z", {}, FitView{}, false, false, group.view})),
    called(&Name::zoom_in, {key::z, none, "", "", ZoomView{1.25}, true}),
    called(&Name::zoom_out, {key::z, shift, "", "", ZoomView{0.8}, true}),

    said(&Row::modes, {key::q, none, "Q Y L", {}, ToggleMode{StageMode::predict}, false, false, group.stage}),
    KeyBinding{key::y, none, "", "", ToggleMode{StageMode::why}},
    KeyBinding{key::l, none, "", "", ToggleMode{StageMode::landscape}},
    said(&Row::more_modes, {key::o, none, "O H S", {}, ToggleMode{StageMode::round}}),
    KeyBinding{key::h, none, "", "", ToggleMode{StageMode::ribbon}},
    KeyBinding{key::s, none, "", "", MeasureHand{}},
    said(&Row::enter, {key::enter, none, "Enter", {}, Confirm{}}),
    row_of(keys.lessons.shown, nullptr, bound(keys.lessons, &Name::lessons, ToggleDialog{Dialog::lessons}, true)),
    called(&Name::next_step, said(&Row::lesson_steps, {key::page_down, none, "PgDn PgUp", {}, NextStep{}})),
    called(&Name::previous_step, {key::page_up, none, "", "", PreviousStep{}}),
    called(&Name::blank, said(&Row::blank, {key::b, none, "B A", {}, ToggleBlank{}})),
    called(&Name::numbers, {key::a, none, "", "", ToggleNumbers{}}),

    said(&Row::escape, {key::escape, none, "Esc", {}, Escape{}, false, true, group.device}),
    row_of(keys.device_status.shown, nullptr, bound(keys.device_status, &Name::device_status, ToggleDialog{Dialog::doctor}, true)),

    called(&Name::undo, said(&Row::undo, {key::z, ctrl, "Ctrl+Z, Ctrl+Y", {}, Undo{}, true, false, group.files})),
    called(&Name::redo, {key::z, ctrl | shift, "", "", Redo{}, true}),
    KeyBinding{key::y, ctrl, "", "", Redo{}, true},
    called(&Name::copy_set_up, said(&Row::set_up, {key::c, ctrl, "Ctrl+C, Ctrl+V", {}, CopySetUp{}})),
    called(&Name::paste_set_up, {key::v, ctrl, "", "", PasteSetUp{}}),
    row_of(keys.link.shown, nullptr, bound(keys.link, &Name::link, ShowLink{})),
    called(&Name::open_scene, said(&Row::scene, {key::o, ctrl, "Ctrl+O, Ctrl+S", {}, ToggleDialog{Dialog::open_scene}, false, true})),
    called(&Name::save_scene, {key::s, ctrl, "", "", ToggleDialog{Dialog::save_scene}, false, true}),
    row_of(keys.pictures, &Row::pictures, bound(keys.save_picture, &Name::save_picture, ToggleDialog{Dialog::save_picture}, true)),
    bound(keys.copy_picture, &Name::copy_picture, CopyPicture{}),
    bound(keys.copy_values, &Name::copy_values, CopyValues{}, true),

    row_of(both(keys.help, palette), &Row::help, bound(keys.help, &Name::help, ToggleDialog{Dialog::help}, true), group.window),
    KeyBinding{palette.key, palette.modifiers, "", "", ToggleDialog{Dialog::palette}, false, true},
    row_of(both(switch_face, keys.plots), &Row::faces, bound(switch_face, &Name::switch_face, SwitchFace{}, true)),
    bound(keys.plots, &Name::plots, TogglePlots{}, true),
    row_of(both(keys.full_screen, keys.next_theme), &Row::full_screen, bound(keys.full_screen, &Name::full_screen, ToggleFullScreen{}, true)),
    bound(keys.next_theme, &Name::next_theme, NextTheme{}),
    for_own_window(called(&Name::larger_text, said(&Row::text_size, {key::equal, ctrl, "Ctrl+ + − 0", {}, ChangeTextSize{1}, true}))),
    for_own_window({key::equal, ctrl | shift, "", "", ChangeTextSize{1}, true}),
    for_own_window(called(&Name::smaller_text, {key::minus, ctrl, "", "", ChangeTextSize{-1}, true})),
    for_own_window(called(&Name::usual_text, {key::digit_0, ctrl, "", "", UseUsualTextSize{}})),
    said(&Row::tab, {key::tab, none, "Tab", {}, std::nullopt, true}),
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

std::string_view sentence_in(const StageLanguage& language, const KeyBinding& binding) noexcept {
  if (binding.row != nullptr) return language.key_rows.*binding.row;
  return binding.named != nullptr ? (language.actions.*binding.named).words : std::string_view();
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
  const StageLanguage::KeyGroups& group = english_stage.key_groups;
  const StageLanguage::MouseRows& rows = english_stage.mouse_rows;
  static const std::array gestures{MouseGesture{group.change, rows.drag.keys, rows.drag.words},
                                   MouseGesture{group.change, rows.grips.keys, rows.grips.words},
                                   MouseGesture{group.view, rows.view.keys, rows.view.words},
                                   MouseGesture{group.change, rows.slider.keys, rows.slider.words}};
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
