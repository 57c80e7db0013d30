#include "app/state/key_bindings.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

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
KeyBinding bound(const FrontKey& at, ActionWords words, const Action& action, bool also_in_fields = false,
                 std::string_view group = {}) {
  return called(words, {.key = at.key,
                        .modifiers = at.modifiers,
                        .shown = at.shown,
                        .sentence = {},
                        .action = action,
                        .also_in_fields = also_in_fields && !types_a_sign(at.key, at.modifiers),
                        .group = group});
}

constexpr int none = 0;
constexpr int shift = modifier::shift;
constexpr int ctrl = modifier::control;
constexpr int alt = modifier::alt;

// clang-format off
constexpr std::array gestures{
    MouseGesture{"Move and change", "Drag", "Move the goal of your hand"},
    MouseGesture{"Move and change", "Drag rail or arrow", "Turn the actuated direction in steps of 5° (Ctrl: freely)"},
    MouseGesture{"Move and change", "Drag a wall grip", "Turn the wall in steps of 5° (Ctrl: freely)"},
    MouseGesture{"View", "Wheel", "Zoom at the pointer"},
    MouseGesture{"View", "Right drag", "Move the view"},
    MouseGesture{"Move and change", "Ctrl+click a slider", "Type a number"},
};
// clang-format on

}  // namespace

std::vector<KeyBinding> key_table_of(const FrontKeys& keys) {
  using Name = StageLanguage::Actions;
  // clang-format off
  std::vector bindings{
    KeyBinding{key::left, none, "Arrows", "Move goal or guess 1 mm (Shift: 0.1, Ctrl: 10)", move_hand(-1, 0, 10), true, false, "Move and change"},
    KeyBinding{key::right, none, "", "", move_hand(1, 0, 10), true},
    KeyBinding{key::up, none, "", "", move_hand(0, 1, 10), true},
    KeyBinding{key::down, none, "", "", move_hand(0, -1, 10), true},
    KeyBinding{key::left, shift, "", "", move_hand(-1, 0, 1), true},
    KeyBinding{key::right, shift, "", "", move_hand(1, 0, 1), true},
    KeyBinding{key::up, shift, "", "", move_hand(0, 1, 1), true},
    KeyBinding{key::down, shift, "", "", move_hand(0, -1, 1), true},
    KeyBinding{key::left, ctrl, "", "", move_hand(-1, 0, 100), true},
    KeyBinding{key::right, ctrl, "", "", move_hand(1, 0, 100), true},
    KeyBinding{key::up, ctrl, "", "", move_hand(0, 1, 100), true},
    KeyBinding{key::down, ctrl, "", "", move_hand(0, -1, 100), true},
    called(&Name::turn_motor_left, {key::left_bracket, none, "[  ]", "Turn the actuated direction 5° (Shift: 1°)", TurnMotorBy{5}, true}),
    called(&Name::turn_motor_right, {key::right_bracket, none, "", "", TurnMotorBy{-5}, true}),
    KeyBinding{key::left_bracket, shift, "", "", TurnMotorBy{1}, true},
    KeyBinding{key::right_bracket, shift, "", "", TurnMotorBy{-1}, true},
    called(&Name::largest_drift, {key::w, none, "W", {}, TurnWallToLargestDrift{}}),
    called(&Name::lower_ratio, {key::minus, none, "−  +", "Lower or raise the ratio ρ by 5 % (Alt: 1 %)", turn_ratio_by(-50), true}),
    called(&Name::raise_ratio, {key::equal, none, "", "", turn_ratio_by(50), true}),
    KeyBinding{key::number_pad_subtract, none, "", "", turn_ratio_by(-50), true},
    KeyBinding{key::number_pad_add, none, "", "", turn_ratio_by(50), true},
    KeyBinding{key::minus, alt, "", "", turn_ratio_by(-10), true},
    KeyBinding{key::equal, alt, "", "", turn_ratio_by(10), true},
    KeyBinding{key::equal, alt | shift, "", "", turn_ratio_by(10), true},
    KeyBinding{key::number_pad_subtract, alt, "", "", turn_ratio_by(-10), true},
    KeyBinding{key::number_pad_add, alt, "", "", turn_ratio_by(10), true},

    KeyBinding{key::digit_1, none, "1 2 3", "Fully actuated, naïve, anisotropic; in a lesson: answer", ChooseByNumber{StrategyId::full}, false, false, "Strategies"},
    KeyBinding{key::digit_2, none, "", "", ChooseByNumber{StrategyId::naive}},
    KeyBinding{key::digit_3, none, "", "", ChooseByNumber{StrategyId::anisotropic}},
    KeyBinding{key::digit_1, shift, "Shift+1 2 3", "The same in slow motion, on the stage", ChooseStrategy{StrategyId::full, true}},
    KeyBinding{key::digit_2, shift, "", "", ChooseStrategy{StrategyId::naive, true}},
    KeyBinding{key::digit_3, shift, "", "", ChooseStrategy{StrategyId::anisotropic, true}},

    called(&Name::pause, {key::space, none, "Space", {}, TogglePause{}, false, false, "Time"}),
    called(&Name::step_back, {key::comma, none, ",", {}, StepBack{}, true}),
    called(&Name::step_on, {key::period, none, ".", {}, StepOn{}, true}),
    called(&Name::restart, {key::r, none, "R", {}, Restart{}}),
    called(&Name::restart_with_settings, {key::r, alt, "Alt+R", {}, Restart{true}}),

    called(&Name::next_comparison, {key::digit_0, none, "0", {}, NextCompareMode{}, false, false, "View"}),
    called(&Name::ghost_forces, {key::g, none, "G", {}, ToggleViewOption{&ViewOptions::ghost_forces}}),
    called(&Name::predictions, {key::p, none, "P", {}, ToggleViewOption{&ViewOptions::predictions}}),
    called(&Name::trails, {key::t, none, "T", {}, ToggleViewOption{&ViewOptions::trails}}),
    called(&Name::fit_view, {key::f, none, "F", {}, FitView{}}),
    called(&Name::zoom_in, {key::z, none, "Z", keys.zoom_sentence, ZoomView{1.25}, true}),
    called(&Name::zoom_out, {key::z, shift, "", "", ZoomView{0.8}, true}),
    KeyBinding{key::left, keys.move_view_modifiers, "", "", move_picture(-1, 0), true},
    KeyBinding{key::right, keys.move_view_modifiers, "", "", move_picture(1, 0), true},
    KeyBinding{key::up, keys.move_view_modifiers, "", "", move_picture(0, 1), true},
    KeyBinding{key::down, keys.move_view_modifiers, "", "", move_picture(0, -1), true},

    KeyBinding{key::q, none, "Q", "Predict: guess where the handle comes to rest", ToggleMode{StageMode::predict}, false, false, "Stage"},
    KeyBinding{key::y, none, "Y", "Why?: where the ghost force comes from", ToggleMode{StageMode::why}},
    KeyBinding{key::l, none, "L", "Landscape: the ghost force for all walls and hands", ToggleMode{StageMode::landscape}},
    KeyBinding{key::o, none, "O", "Round and round: the energy of a closed loop", ToggleMode{StageMode::round}},
    KeyBinding{key::h, none, "H", "Last minute: look at it again", ToggleMode{StageMode::ribbon}},
    KeyBinding{key::s, none, "S", "Measure my hand: how stiff it is", MeasureHand{}},
    KeyBinding{key::enter, none, "Enter", "Next step of a lesson or of Why?; answer a guess", Confirm{}},
    KeyBinding{key::number_pad_enter, none, "", "", Confirm{}},
    bound(keys.lessons, &Name::lessons, ToggleDialog{Dialog::lessons}, true),
    called(&Name::next_step, {key::page_down, none, "PgDn PgUp", "Lesson or talk: next / previous step", NextStep{}}),
    called(&Name::previous_step, {key::page_up, none, "", "", PreviousStep{}}),
    called(&Name::blank, {key::b, none, "B", {}, ToggleBlank{}}),
    called(&Name::numbers, {key::a, none, "A", {}, ToggleNumbers{}}),

    bound(keys.device_status, &Name::device_status, ToggleDialog{Dialog::doctor}, true, "Device"),
    KeyBinding{key::escape, none, "Esc", "Motors off; once they are off, close what is open (never quits)", Escape{}, false, true},

    called(&Name::undo, {key::z, ctrl, "Ctrl+Z", {}, Undo{}, true, false, "Undo, files, clipboard"}),
    called(&Name::redo, {key::z, ctrl | shift, "Ctrl+Shift+Z", "Redo; also Ctrl+Y", Redo{}, true}),
    KeyBinding{key::y, ctrl, "", "", Redo{}, true},
    called(&Name::copy_set_up, {key::c, ctrl, "Ctrl+C", {}, CopySetUp{}}),
    called(&Name::paste_set_up, {key::v, ctrl, "Ctrl+V", {}, PasteSetUp{}}),
    bound(keys.link, &Name::link, ShowLink{}),
    called(&Name::open_scene, {key::o, ctrl, "Ctrl+O", {}, ToggleDialog{Dialog::open_scene}, false, true}),
    called(&Name::save_scene, {key::s, ctrl, "Ctrl+S", {}, ToggleDialog{Dialog::save_scene}, false, true}),
    bound(keys.save_picture, &Name::save_picture, ToggleDialog{Dialog::save_picture}, true),
    bound(keys.save_clip, &Name::save_clip, ToggleDialog{Dialog::save_clip}, true),
    bound(keys.copy_picture, &Name::copy_picture, CopyPicture{}),
    bound(keys.copy_values, &Name::copy_values, CopyValues{}, true),

    bound(keys.help, &Name::help, ToggleDialog{Dialog::help}, true, "Window"),
    KeyBinding{key::p, ctrl, "Ctrl+P", "Every action by its words: type, then Enter", ToggleDialog{Dialog::palette}, false, true},
    bound(keys.plots, &Name::plots, TogglePlots{}, true),
    called(&Name::switch_face, {key::f4, none, "F4", {}, SwitchFace{}, false, true}),
    bound(keys.full_screen, &Name::full_screen, ToggleFullScreen{}, true),
    bound(keys.next_theme, &Name::next_theme, NextTheme{}),
    for_own_window(called(&Name::larger_text, {key::equal, ctrl, "Ctrl+ + − 0", "Text size: larger, smaller, default", ChangeTextSize{1}, true})),
    for_own_window({key::equal, ctrl | shift, "", "", ChangeTextSize{1}, true}),
    for_own_window({key::number_pad_add, ctrl, "", "", ChangeTextSize{1}, true}),
    for_own_window(called(&Name::smaller_text, {key::minus, ctrl, "", "", ChangeTextSize{-1}, true})),
    for_own_window({key::number_pad_subtract, ctrl, "", "", ChangeTextSize{-1}, true}),
    for_own_window(called(&Name::usual_text, {key::digit_0, ctrl, "", "", UseUsualTextSize{}})),
    KeyBinding{key::tab, none, "Tab", "Next control (Shift: previous)", std::nullopt, true},
    KeyBinding{key::tab, shift, "", "", std::nullopt, true},
    for_own_window(called(&Name::quit, {key::q, ctrl, "Ctrl+Q", {}, Quit{}, false, true})),
    for_own_window({key::q, ctrl | alt | shift, "", "", Quit{.ends_visit = true}, false, true}),  // told on the terminal
  };
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

std::optional<Action> action_of_key(const KeyPress& press, bool is_typing) {
  const auto acts = [&](const KeyBinding& binding) {
    return binding.key == press.key && binding.modifiers == press.modifiers && (!press.is_repeat || binding.repeats) &&
           (!is_typing || binding.also_in_fields);
  };
  const auto found = std::ranges::find_if(key_table(), acts);
  return found == key_table().end() ? std::nullopt : found->action;
}

bool is_ours(const KeyPress& press, bool is_typing) {
  if (is_typing && is_for_field(press)) return true;
  return std::ranges::any_of(key_table(), [&](const KeyBinding& binding) {
    return binding.key == press.key && binding.modifiers == press.modifiers && (!is_typing || binding.also_in_fields);
  });
}

}  // namespace ghostforce
