// The keys that differ between the two fronts of the program: a browser keeps some for itself. All other keys are in
// key_bindings.cpp alone. Values, any thread.
#pragma once

#include <string_view>

#include "app/state/keys.h"

namespace ghostforce {

struct FrontKey {
  int key;                 // of keys.h
  int modifiers;           // of keys.h
  std::string_view shown;  // as printed on the keys
};

struct FrontKeys {
  FrontKey help;
  FrontKey lessons;
  FrontKey device_status;
  FrontKey plots;
  FrontKey full_screen;
  FrontKey next_theme;
  FrontKey save_picture;
  FrontKey copy_picture;
  FrontKey copy_values;
  FrontKey link;            // no key where there is no page to link to
  int move_view_modifiers;  // of the arrows that move the view

  // Of what these keys do, where that differs too.
  std::string_view pictures;            // the keys that save and copy, in a row
  std::string_view text_size_sentence;  // of the setting
  std::string_view controls;  // that leads to the words and controls beside the picture; empty: there are none

  // Keys that quit and that change the size of text. A browser closes and zooms its pages itself.
  bool has_own_window;
};

// Both are here, so that a test of one front can read the other's.
inline constexpr FrontKeys keys_on_desktop{
    .help = {key::f1, 0, "F1"},
    .lessons = {key::f5, 0, "F5"},
    .device_status = {key::f2, 0, "F2"},
    .plots = {key::f3, 0, "F3"},
    .full_screen = {key::f11, 0, "F11"},
    .next_theme = {key::t, modifier::control, "Ctrl+T"},
    .save_picture = {key::s, modifier::control | modifier::shift, "Ctrl+Shift+S"},
    .copy_picture = {key::p, modifier::control | modifier::shift, "Ctrl+Shift+P"},
    .copy_values = {key::c, modifier::control | modifier::shift, "Ctrl+Shift+C"},
    .link = {},
    .move_view_modifiers = modifier::alt,
    .pictures = "Ctrl+Shift+S, P, C",
    .text_size_sentence = "The size of text and lines, 75 to 300 %. Also Ctrl and + or −; Ctrl+0 restores the default.",
    .controls = "",
    .has_own_window = true};

// Letters that nothing else has: browsers leave them alone.
inline constexpr FrontKeys keys_in_page{
    .help = {key::k, 0, "K"},
    .lessons = {key::m, 0, "M"},
    .device_status = {key::d, 0, "D"},
    .plots = {key::n, 0, "N"},
    .full_screen = {key::x, 0, "X"},
    .next_theme = {key::c, 0, "C"},
    .save_picture = {key::i, 0, "I"},
    .copy_picture = {key::i, modifier::shift, "Shift+I"},
    .copy_values = {key::v, 0, "V"},
    .link = {key::u, 0, "U"},
    .move_view_modifiers = modifier::shift | modifier::alt,
    .pictures = "I, Shift+I, V",
    .text_size_sentence = "The size of text and lines, 75 to 300 %. The browser's own zoom changes it too.",
    .controls = "Tab",
    .has_own_window = false};

// Those of the front that this is.
const FrontKeys& front_keys() noexcept;

}  // namespace ghostforce
