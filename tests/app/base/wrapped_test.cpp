#include "app/base/words.h"

#include <gtest/gtest.h>

namespace ghostforce::wrapped_test {
namespace {

TEST(Wrapped, BreaksWhereALineWouldBeTooLong) {
  EXPECT_EQ(wrapped("one two three", 7), "one two\nthree");
  EXPECT_EQ(wrapped("one two three", 8), "one two\nthree");
  EXPECT_EQ(wrapped("one two three", 13), "one two three");
  EXPECT_EQ(wrapped("one two three", 6), "one\ntwo\nthree");
  EXPECT_EQ(wrapped("", 7), "");
}

TEST(Wrapped, IndentsAllLinesButTheFirst) {
  EXPECT_EQ(wrapped("one two three four", 7, "  "), "one two\n  three\n  four");
}

TEST(Wrapped, LeavesALongWordWhole) {
  EXPECT_EQ(wrapped("a incomprehensible b", 5), "a\nincomprehensible\nb");
  EXPECT_EQ(wrapped("incomprehensible", 5), "incomprehensible");
}

}  // namespace
}  // namespace ghostforce::wrapped_test
