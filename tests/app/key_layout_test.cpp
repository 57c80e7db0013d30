// Which key is meant, on keyboards of several countries.
#include "app/key_layout.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace ghostforce {
namespace {

TEST(KeyLayout, LettersAreWhereTheyArePrinted) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_Q, "a", 0), GLFW_KEY_A) << "AZERTY";
  EXPECT_EQ(key_by_layout(GLFW_KEY_SEMICOLON, "m", 0), GLFW_KEY_M) << "AZERTY";
  EXPECT_EQ(key_by_layout(GLFW_KEY_W, "z", GLFW_MOD_CONTROL), GLFW_KEY_Z) << "AZERTY";
  EXPECT_EQ(key_by_layout(GLFW_KEY_Y, "z", GLFW_MOD_CONTROL), GLFW_KEY_Z) << "QWERTZ";
  EXPECT_EQ(key_by_layout(GLFW_KEY_Z, "Y", GLFW_MOD_SHIFT), GLFW_KEY_Y) << "QWERTZ";
}

TEST(KeyLayout, DigitsAreWhereTheyAreOnAnyKeyboard) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_1, "&", 0), GLFW_KEY_1) << "AZERTY";
  EXPECT_EQ(key_by_layout(GLFW_KEY_2, "\xC3\xA9", 0), GLFW_KEY_2) << "AZERTY";
  EXPECT_EQ(key_by_layout(GLFW_KEY_3, "3", 0), GLFW_KEY_3);
}

// Spanish and German keyboards: the keys at [ and ].
TEST(KeyLayout, APlusMakesLargerWithCtrlAndTurnsWithout) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_RIGHT_BRACKET, "+", 0), GLFW_KEY_RIGHT_BRACKET);
  EXPECT_EQ(key_by_layout(GLFW_KEY_RIGHT_BRACKET, "+", GLFW_MOD_SHIFT), GLFW_KEY_RIGHT_BRACKET);
  EXPECT_EQ(key_by_layout(GLFW_KEY_RIGHT_BRACKET, "+", GLFW_MOD_CONTROL), GLFW_KEY_EQUAL);
  EXPECT_EQ(key_by_layout(GLFW_KEY_RIGHT_BRACKET, "+", GLFW_MOD_CONTROL | GLFW_MOD_SHIFT), GLFW_KEY_EQUAL);
  EXPECT_EQ(key_by_layout(GLFW_KEY_LEFT_BRACKET, "`", 0), GLFW_KEY_LEFT_BRACKET);
  EXPECT_EQ(key_by_layout(GLFW_KEY_LEFT_BRACKET, "\xC3\xBC", 0), GLFW_KEY_LEFT_BRACKET);
}

TEST(KeyLayout, SignsAreWhereTheyArePrinted) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_SLASH, "-", GLFW_MOD_CONTROL), GLFW_KEY_MINUS) << "QWERTZ";
  EXPECT_EQ(key_by_layout(GLFW_KEY_PERIOD, ".", 0), GLFW_KEY_PERIOD);
  EXPECT_EQ(key_by_layout(GLFW_KEY_SEMICOLON, "[", 0), GLFW_KEY_LEFT_BRACKET);
  EXPECT_EQ(key_by_layout(GLFW_KEY_APOSTROPHE, "]", 0), GLFW_KEY_RIGHT_BRACKET);
}

TEST(KeyLayout, KeysWithoutAnAsciiSignAreWhereTheyAre) {
  EXPECT_EQ(key_by_layout(GLFW_KEY_SPACE, nullptr, 0), GLFW_KEY_SPACE);
  EXPECT_EQ(key_by_layout(GLFW_KEY_F1, "", 0), GLFW_KEY_F1);
  EXPECT_EQ(key_by_layout(GLFW_KEY_Z, "\xD1\x8F", GLFW_MOD_CONTROL), GLFW_KEY_Z) << "Russian";
}

TEST(KeyLayout, TheNumberPadStaysItself) {
  for (const int modifiers : {0, GLFW_MOD_CONTROL}) {
    EXPECT_EQ(key_by_layout(GLFW_KEY_KP_ADD, "+", modifiers), GLFW_KEY_KP_ADD);
    EXPECT_EQ(key_by_layout(GLFW_KEY_KP_SUBTRACT, "-", modifiers), GLFW_KEY_KP_SUBTRACT);
    EXPECT_EQ(key_by_layout(GLFW_KEY_KP_DECIMAL, ".", modifiers), GLFW_KEY_KP_DECIMAL);
    EXPECT_EQ(key_by_layout(GLFW_KEY_KP_7, "7", modifiers), GLFW_KEY_KP_7);
  }
}

}  // namespace
}  // namespace ghostforce
