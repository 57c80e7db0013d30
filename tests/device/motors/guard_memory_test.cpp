// When a guard stops motors, and when it is needed no more.
#include "device/motors/guard_memory.h"

#include <gtest/gtest.h>

namespace ghostforce::guard_memory_test {
namespace {

constexpr std::int64_t beat_ns = 1'000'000'000;
constexpr std::int64_t in_time_ns = beat_ns + longest_beat_gap_ns - 1;
constexpr std::int64_t too_late_ns = beat_ns + longest_beat_gap_ns;

TEST(Guard, StopsMotorsOfAProgramThatDoesNotBeat) {
  EXPECT_EQ(guard_action(false, true, beat_ns, false, in_time_ns), GuardAction::watch);
  EXPECT_EQ(guard_action(false, true, beat_ns, false, too_late_ns), GuardAction::stop_motors);
}

TEST(Guard, StopsMotorsOfAProgramThatIsGoneAtOnce) {
  EXPECT_EQ(guard_action(false, true, beat_ns, true, beat_ns), GuardAction::stop_motors);
}

TEST(Guard, LeavesAProgramAloneWhoseMotorsAreOff) {
  EXPECT_EQ(guard_action(false, false, beat_ns, false, too_late_ns), GuardAction::watch);
  EXPECT_EQ(guard_action(false, false, beat_ns, true, beat_ns), GuardAction::end);
}

TEST(Guard, EndsWhenTheProgramSaysSo) {
  EXPECT_EQ(guard_action(true, true, beat_ns, true, too_late_ns), GuardAction::end);
  EXPECT_EQ(guard_action(true, false, beat_ns, false, beat_ns), GuardAction::end);
}

// Of the 25 ms that are promised some are left to look, and to send.
TEST(Guard, IsInTime) {
  EXPECT_LE(longest_beat_gap_ns, 20'000'000);
}

}  // namespace
}  // namespace ghostforce::guard_memory_test
