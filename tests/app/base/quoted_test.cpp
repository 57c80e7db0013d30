#include "app/base/quoted.h"

#include <array>
#include <string_view>

#include <gtest/gtest.h>

namespace ghostforce::quoted_test {
namespace {

using namespace std::string_view_literals;

TEST(QuotedText, KeepsWordsAndShowsControlCharacters) {
  EXPECT_EQ(quoted_text("wall45 ρ"), "wall45 ρ");
  EXPECT_EQ(quoted_text("a\x1b[2J\n\t\x7f"), "a\\x1B[2J\\x0A\\x09\\x7F");
  EXPECT_EQ(quoted_text("\0b"sv), "\\x00b");
}

TEST(QuotedText, CutsBetweenCharacters) {
  EXPECT_EQ(quoted_text("abcdef", 3), "abc…");
  EXPECT_EQ(quoted_text("abc", 3), "abc");
  EXPECT_EQ(quoted_text("aρρ", 2), "a…");  // ρ takes two bytes
  EXPECT_EQ(quoted_text("aρρ", 3), "aρ…");
}

TEST(QuotedText, Lists) {
  EXPECT_EQ(listed(std::array{"a"sv, "b"sv, "c"sv}), "a, b, c");
  EXPECT_EQ(listed({}), "");
}

}  // namespace
}  // namespace ghostforce::quoted_test
