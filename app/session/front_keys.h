// The keys that differ between the two fronts of the program: a browser keeps some for itself. All other keys are in
// key_bindings.cpp alone. Values, any thread.
#pragma once

#include <string_view>

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
  std::string_view zoom_sentence;
  std::string_view save_picture_sentence;
  std::string_view text_size_sentence;  // of the setting

  // Keys that quit and that change the size of text. A browser closes and zooms its pages itself.
  bool has_own_window;
};

// Those of the front that this is.
const FrontKeys& front_keys() noexcept;

}  // namespace ghostforce
