// Which key is meant, on keyboards of several countries.
#include "app/shell/window.h"

#include <gtest/gtest.h>

#include "app/state/keys.h"

namespace ghostforce::key_layout_test {
namespace {

TEST(KeyLayout, LettersAreWhereTheyArePrinted) {
  EXPECT_EQ(key_by_layout(key::q, "a"), key::a) << "AZERTY";
  EXPECT_EQ(key_by_layout(key::semicolon, "m"), key::m) << "AZERTY";
  EXPECT_EQ(key_by_layout(key::w, "z"), key::z) << "AZERTY";
  EXPECT_EQ(key_by_layout(key::y, "z"), key::z) << "QWERTZ";
  EXPECT_EQ(key_by_layout(key::z, "Y"), key::y) << "QWERTZ";
}

TEST(KeyLayout, DigitsAreWhereTheyAreOnAnyKeyboard) {
  EXPECT_EQ(key_by_layout(key::digit_1, "&"), key::digit_1) << "AZERTY";
  EXPECT_EQ(key_by_layout(key::digit_2, "\xC3\xA9"), key::digit_2) << "AZERTY";
  EXPECT_EQ(key_by_layout(key::digit_3, "3"), key::digit_3);
}

// Spanish and German keyboards: the keys at [ and ].
TEST(KeyLayout, APlusOfItsOwnIsAPlus) {
  EXPECT_EQ(key_by_layout(key::right_bracket, "+"), key::equal);
  EXPECT_EQ(key_by_layout(key::left_bracket, "`"), key::left_bracket);
  EXPECT_EQ(key_by_layout(key::left_bracket, "\xC3\xBC"), key::left_bracket);
}

TEST(KeyLayout, SignsAreWhereTheyArePrinted) {
  EXPECT_EQ(key_by_layout(key::slash, "-"), key::minus) << "QWERTZ";
  EXPECT_EQ(key_by_layout(key::period, "."), key::period);
  EXPECT_EQ(key_by_layout(key::m, ","), key::comma) << "as France has it";
  EXPECT_EQ(key_by_layout(key::semicolon, "["), key::left_bracket);
  EXPECT_EQ(key_by_layout(key::apostrophe, "]"), key::right_bracket);
}

TEST(KeyLayout, KeysWithoutAnAsciiSignAreWhereTheyAre) {
  EXPECT_EQ(key_by_layout(key::space, nullptr), key::space);
  EXPECT_EQ(key_by_layout(key::f1, ""), key::f1);
  EXPECT_EQ(key_by_layout(key::z, "\xD1\x8F"), key::z) << "Russian";
}

TEST(KeyLayout, TheNumberPadStaysItself) {
  EXPECT_EQ(key_by_layout(key::number_pad_add, "+"), key::number_pad_add);
  EXPECT_EQ(key_by_layout(key::number_pad_subtract, "-"), key::number_pad_subtract);
  EXPECT_EQ(key_by_layout(key::number_pad_decimal, "."), key::number_pad_decimal);
  EXPECT_EQ(key_by_layout(key::number_pad_7, "7"), key::number_pad_7);
}

// As GLFW tells them: the key with its modifiers, then what it has typed.
TEST(KeyLayout, WhatWasTypedDecides) {
  struct Case {
    const char* keyboard;
    KeyPress pressed;
    std::uint32_t character;
    int key;
    int modifiers;
  };
  for (const Case& c : {
           Case{"US: Shift+=", {key::equal, modifier::shift}, '+', key::equal, 0},
           Case{"US: =", {key::equal, 0}, '=', key::equal, 0},
           Case{"US: -", {key::minus, 0}, '-', key::minus, 0},
           Case{"US: Shift+-", {key::minus, modifier::shift}, '_', key::minus, modifier::shift},
           Case{"US: Shift+[", {key::left_bracket, modifier::shift}, '{', key::left_bracket, modifier::shift},
           Case{"German: +", {key::equal, 0}, '+', key::equal, 0},
           Case{"German: AltGr+9", {key::digit_9, 0}, ']', key::right_bracket, 0},
           Case{"Swiss: Shift+1", {key::digit_1, modifier::shift}, '+', key::equal, 0},
           Case{"Japanese: Shift+;", {key::semicolon, modifier::shift}, '+', key::equal, 0},
           Case{"number pad: +", {key::number_pad_add, 0}, '+', key::equal, 0},
           Case{"number pad: -", {key::number_pad_subtract, 0}, '-', key::minus, 0},
           Case{"a minus sign", {key::digit_8, 0}, 0x2212, key::minus, 0},
           Case{"3", {key::digit_3, 0}, '3', key::digit_3, 0},
       }) {
    const KeyPress meant = press_by_character(c.pressed, c.character);
    EXPECT_EQ(meant.key, c.key) << c.keyboard;
    EXPECT_EQ(meant.modifiers, c.modifiers) << c.keyboard;
  }
  EXPECT_TRUE(press_by_character({key::equal, modifier::shift, true}, '+').is_repeat);
}

}  // namespace
}  // namespace ghostforce::key_layout_test
