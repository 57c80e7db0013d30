// Which key was pressed, on whatever keyboard. Pure, any thread.
#pragma once

#include <cstdint>

#include "app/state/key_bindings.h"

namespace ghostforce {

// `key` is one of keys.h by its place on a US keyboard. `name` is what the layout has on it, in UTF-8; null: nothing.
//
// Returns the one that is meant. By what is printed on the key where that is a letter, bracket, dot or minus:
// Ctrl+Z is where the Z is. Otherwise by its place: the digits of a French keyboard, what no ASCII sign is printed on,
// and the number pad. A plus of its own, as at ] of German and Spanish keyboards, is key::equal.
int key_by_layout(int key, const char* name) noexcept;

// The press once it is known what it has typed, which layouts make with Shift or AltGr as they please: a plus, a minus
// or a bracket is key::equal, key::minus, key::left_bracket or key::right_bracket without Shift.
// Anything else stays the key that it is. With Ctrl or Alt nothing is typed.
KeyPress press_by_character(KeyPress press, std::uint32_t character) noexcept;

// The modifier of a key that is a modifier itself; 0: it is none.
int modifier_of(int key) noexcept;

}  // namespace ghostforce
