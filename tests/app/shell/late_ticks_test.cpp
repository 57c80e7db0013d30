// Which ticks the status bar calls late.
#include "app/shell/frame_pacer.h"

#include <gtest/gtest.h>

namespace ghostforce::late_ticks_test {
namespace {

constexpr double frame_s = 0.125;  // a number without rounding

TEST(LateTicks, AreCountedOnceAndForgottenAfterAWhile) {
  LateTicks late(1.0);
  late.note(0, false, frame_s);
  late.note(3, false, frame_s);
  late.note(3, false, frame_s);
  late.note(5, false, frame_s);
  EXPECT_EQ(late.all(), 5U);
  EXPECT_EQ(late.lately(), 5U);
  for (int i = 0; i < 6; ++i) late.note(5, false, frame_s);
  EXPECT_EQ(late.lately(), 2U) << "the three are a second old";
  late.note(5, false, 2.0 * frame_s);
  EXPECT_EQ(late.lately(), 0U);
  EXPECT_EQ(late.all(), 5U);
}

TEST(LateTicks, WhileADeviceIsOpenedDoNotCount) {
  LateTicks late(1.0);
  late.note(1000, true, frame_s);
  late.note(1089, true, frame_s);
  late.note(1090, false, frame_s);
  EXPECT_EQ(late.all(), 0U) << "what came last was still on the way when it was opened";
  late.note(1092, false, frame_s);
  EXPECT_EQ(late.all(), 2U);
}

TEST(LateTicks, ANewLoopBeginsAtZero) {
  LateTicks late(1.0);
  late.note(50, false, frame_s);
  late.note(2, false, frame_s);
  EXPECT_EQ(late.all(), 52U);
}

}  // namespace
}  // namespace ghostforce::late_ticks_test
