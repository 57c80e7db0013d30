// When a guard stops motors, and when it is needed no more.
#include "device/motor_guard/guard_page.h"

#include <gtest/gtest.h>

namespace ghostforce::guard_page_test {
namespace {

constexpr std::int64_t beat_ns = 1'000'000'000;
constexpr std::int64_t in_time_ns = beat_ns + longest_beat_gap_ns - 1;
constexpr std::int64_t too_late_ns = beat_ns + longest_beat_gap_ns;

TEST(Guard, StopsMotorsOfAProgramThatDoesNotBeat) {
  EXPECT_EQ(deed_of(false, true, beat_ns, false, in_time_ns), GuardDeed::watch);
  EXPECT_EQ(deed_of(false, true, beat_ns, false, too_late_ns), GuardDeed::stop_motors);
}

TEST(Guard, StopsMotorsOfAProgramThatIsGoneAtOnce) {
  EXPECT_EQ(deed_of(false, true, beat_ns, true, beat_ns), GuardDeed::stop_motors);
}

TEST(Guard, LeavesAProgramAloneWhoseMotorsAreOff) {
  EXPECT_EQ(deed_of(false, false, beat_ns, false, too_late_ns), GuardDeed::watch);
  EXPECT_EQ(deed_of(false, false, beat_ns, true, beat_ns), GuardDeed::end);
}

TEST(Guard, EndsWhenTheProgramSaysSo) {
  EXPECT_EQ(deed_of(true, true, beat_ns, true, too_late_ns), GuardDeed::end);
  EXPECT_EQ(deed_of(true, false, beat_ns, false, beat_ns), GuardDeed::end);
}

// Of the 25 ms that are promised some are left to look, and to send.
TEST(Guard, IsInTime) {
  EXPECT_LE(longest_beat_gap_ns, 20'000'000);
}

}  // namespace
}  // namespace ghostforce::guard_page_test
