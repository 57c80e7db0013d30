// Which key is meant, on keyboards of several countries.
#include "app/ui/key_layout.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace ghostforce {
namespace {

TEST(KeyLayout, LettersAreWhereTheyArePrinted) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_Q, "a"), GLFW_KEY_A) << "AZERTY";
  EXPECT_EQ(key_by_layout(GLFW_KEY_SEMICOLON, "m"), GLFW_KEY_M) << "AZERTY";
  EXPECT_EQ(key_by_layout(GLFW_KEY_W, "z"), GLFW_KEY_Z) << "AZERTY";
  EXPECT_EQ(key_by_layout(GLFW_KEY_Y, "z"), GLFW_KEY_Z) << "QWERTZ";
  EXPECT_EQ(key_by_layout(GLFW_KEY_Z, "Y"), GLFW_KEY_Y) << "QWERTZ";
}

TEST(KeyLayout, DigitsAreWhereTheyAreOnAnyKeyboard) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_1, "&"), GLFW_KEY_1) << "AZERTY";
  EXPECT_EQ(key_by_layout(GLFW_KEY_2, "\xC3\xA9"), GLFW_KEY_2) << "AZERTY";
  EXPECT_EQ(key_by_layout(GLFW_KEY_3, "3"), GLFW_KEY_3);
}

// Spanish and German keyboards: the keys at [ and ].
TEST(KeyLayout, APlusOfItsOwnIsAPlus) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_RIGHT_BRACKET, "+"), GLFW_KEY_EQUAL);
  EXPECT_EQ(key_by_layout(GLFW_KEY_LEFT_BRACKET, "`"), GLFW_KEY_LEFT_BRACKET);
  EXPECT_EQ(key_by_layout(GLFW_KEY_LEFT_BRACKET, "\xC3\xBC"), GLFW_KEY_LEFT_BRACKET);
}

TEST(KeyLayout, SignsAreWhereTheyArePrinted) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_SLASH, "-"), GLFW_KEY_MINUS) << "QWERTZ";
  EXPECT_EQ(key_by_layout(GLFW_KEY_PERIOD, "."), GLFW_KEY_PERIOD);
  EXPECT_EQ(key_by_layout(GLFW_KEY_M, ","), GLFW_KEY_COMMA) << "as France has it";
  EXPECT_EQ(key_by_layout(GLFW_KEY_SEMICOLON, "["), GLFW_KEY_LEFT_BRACKET);
  EXPECT_EQ(key_by_layout(GLFW_KEY_APOSTROPHE, "]"), GLFW_KEY_RIGHT_BRACKET);
}

TEST(KeyLayout, KeysWithoutAnAsciiSignAreWhereTheyAre) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_SPACE, nullptr), GLFW_KEY_SPACE);
  EXPECT_EQ(key_by_layout(GLFW_KEY_F1, ""), GLFW_KEY_F1);
  EXPECT_EQ(key_by_layout(GLFW_KEY_Z, "\xD1\x8F"), GLFW_KEY_Z) << "Russian";
}

TEST(KeyLayout, TheNumberPadStaysItself) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_KP_ADD, "+"), GLFW_KEY_KP_ADD);
  EXPECT_EQ(key_by_layout(GLFW_KEY_KP_SUBTRACT, "-"), GLFW_KEY_KP_SUBTRACT);
  EXPECT_EQ(key_by_layout(GLFW_KEY_KP_DECIMAL, "."), GLFW_KEY_KP_DECIMAL);
  EXPECT_EQ(key_by_layout(GLFW_KEY_KP_7, "7"), GLFW_KEY_KP_7);
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
           Case{"US: Shift+=", {GLFW_KEY_EQUAL, GLFW_MOD_SHIFT}, '+', GLFW_KEY_EQUAL, 0},
           Case{"US: =", {GLFW_KEY_EQUAL, 0}, '=', GLFW_KEY_EQUAL, 0},
           Case{"US: -", {GLFW_KEY_MINUS, 0}, '-', GLFW_KEY_MINUS, 0},
           Case{"US: Shift+-", {GLFW_KEY_MINUS, GLFW_MOD_SHIFT}, '_', GLFW_KEY_MINUS, GLFW_MOD_SHIFT},
           Case{"US: Shift+[", {GLFW_KEY_LEFT_BRACKET, GLFW_MOD_SHIFT}, '{', GLFW_KEY_LEFT_BRACKET, GLFW_MOD_SHIFT},
           Case{"German: +", {GLFW_KEY_EQUAL, 0}, '+', GLFW_KEY_EQUAL, 0},
           Case{"German: AltGr+9", {GLFW_KEY_9, 0}, ']', GLFW_KEY_RIGHT_BRACKET, 0},
           Case{"Swiss: Shift+1", {GLFW_KEY_1, GLFW_MOD_SHIFT}, '+', GLFW_KEY_EQUAL, 0},
           Case{"Japanese: Shift+;", {GLFW_KEY_SEMICOLON, GLFW_MOD_SHIFT}, '+', GLFW_KEY_EQUAL, 0},
           Case{"number pad: +", {GLFW_KEY_KP_ADD, 0}, '+', GLFW_KEY_EQUAL, 0},
           Case{"number pad: -", {GLFW_KEY_KP_SUBTRACT, 0}, '-', GLFW_KEY_MINUS, 0},
           Case{"a minus sign", {GLFW_KEY_8, 0}, 0x2212, GLFW_KEY_MINUS, 0},
           Case{"3", {GLFW_KEY_3, 0}, '3', GLFW_KEY_3, 0},
       }) {
    const KeyPress meant = press_by_character(c.pressed, c.character);
    EXPECT_EQ(meant.key, c.key) << c.keyboard;
    EXPECT_EQ(meant.modifiers, c.modifiers) << c.keyboard;
  }
  EXPECT_TRUE(press_by_character({GLFW_KEY_EQUAL, GLFW_MOD_SHIFT, true}, '+').is_repeat);
}

}  // namespace
}  // namespace ghostforce
