// Which readings of encoders are believed, and when a position that cannot be found has been lost.
#include "device/motors/leap_filter.h"

#include <array>

#include <gtest/gtest.h>

#include "device/motors/position_times.h"

namespace ghostforce::leap_filter_test {
namespace {

constexpr std::int64_t ms = 1'000'000;

using Counts = std::array<std::int16_t, 2>;
using Filter = LeapFilter<Counts>;
using Verdict = Filter::Verdict;

// 10 counts, 2 more with each millisecond, 50 at most.
Filter at_rest() {
  Filter filter({.least = 10.0, .per_s = 2000.0, .per_s_squared = 0.0, .greatest = 50.0});
  filter.add({100, 200}, 1000 * ms);
  return filter;
}

TEST(LeapFilter, TheFirstIsBelieved) {
  Filter filter({.least = 10.0, .per_s = 2000.0, .per_s_squared = 0.0, .greatest = 50.0});
  EXPECT_EQ(filter.add({3000, -3000}, 1000 * ms), Verdict::believed);
}

TEST(LeapFilter, AHandMayMoveFartherInMoreTime) {
  EXPECT_EQ(at_rest().add({112, 188}, 1001 * ms), Verdict::believed);
  EXPECT_EQ(at_rest().add({113, 200}, 1001 * ms), Verdict::odd);
  EXPECT_EQ(at_rest().add({100, 187}, 1001 * ms), Verdict::odd) << "any of them";
  EXPECT_EQ(at_rest().add({150, 200}, 1020 * ms), Verdict::believed);
  EXPECT_EQ(at_rest().add({151, 200}, 2000 * ms), Verdict::odd) << "more cannot be told from a mistake";
}

TEST(LeapFilter, OneOddReadingIsNoLossAndNoProof) {
  Filter filter = at_rest();
  EXPECT_EQ(filter.add({500, 200}, 1001 * ms), Verdict::odd);
  EXPECT_EQ(filter.add({101, 200}, 1002 * ms), Verdict::believed);
  EXPECT_EQ(filter.add({500, 200}, 1003 * ms), Verdict::odd);
  EXPECT_EQ(filter.add({500, 200}, 1004 * ms), Verdict::odd) << "the first one is forgotten";
}

TEST(LeapFilter, ThreeThatSayTheSameAreBelieved) {
  Filter filter = at_rest();
  EXPECT_EQ(filter.add({500, 200}, 1001 * ms), Verdict::odd);
  EXPECT_EQ(filter.add({900, 200}, 1002 * ms), Verdict::odd) << "another one";
  EXPECT_EQ(filter.add({905, 200}, 1003 * ms), Verdict::odd);
  EXPECT_EQ(filter.add({910, 200}, 1004 * ms), Verdict::leapt);
  EXPECT_EQ(filter.add({911, 200}, 1005 * ms), Verdict::believed);
}

// After 4 ms without a believed reading, 18 counts could be a motion.
TEST(LeapFilter, ALeapDoesNotBecomeAMotionWithTime) {
  Filter filter = at_rest();
  EXPECT_EQ(filter.add({115, 200}, 1001 * ms), Verdict::odd);
  EXPECT_EQ(filter.add({115, 200}, 1004 * ms), Verdict::odd);
  EXPECT_EQ(filter.add({116, 200}, 1005 * ms), Verdict::leapt);
}

TEST(LeapFilter, AMotionGoesOn) {
  const auto begun = [] {
    Filter filter({.least = 10.0, .per_s = 0.0, .per_s_squared = 2e6, .greatest = 50.0});
    filter.add({0, 0}, 1000 * ms);
    filter.add({8, 0}, 1001 * ms);
    filter.add({16, 0}, 1002 * ms);
    return filter;
  };
  EXPECT_EQ(begun().add({35, 0}, 1003 * ms), Verdict::believed) << "11 more than at the same speed";
  EXPECT_EQ(begun().add({36, 0}, 1003 * ms), Verdict::odd);
  EXPECT_EQ(begun().add({16, 0}, 1003 * ms), Verdict::believed) << "it stops";
  EXPECT_EQ(begun().add({4, 0}, 1003 * ms), Verdict::odd) << "it does not turn round at once";
  EXPECT_EQ(begun().add({54, 0}, 1006 * ms), Verdict::believed) << "it may have become faster";
  EXPECT_EQ(begun().add({100, 0}, 1500 * ms), Verdict::believed) << "what it did half a second ago says nothing";
}

TEST(LeapFilter, AfterAResetWhateverComesIsBelieved) {
  Filter filter = at_rest();
  filter.add({500, 200}, 1001 * ms);
  filter.reset();
  EXPECT_EQ(filter.add({-500, 700}, 1002 * ms), Verdict::believed);
}

TEST(PositionTimes, ALossIsOneAfterTenMilliseconds) {
  PositionTimes times;
  EXPECT_EQ(times.asked_ns(), 0);
  times.found(5 * ms, 6 * ms);
  EXPECT_EQ(times.asked_ns(), 5 * ms);
  EXPECT_EQ(times.heard_ns(), 6 * ms);
  EXPECT_FALSE(times.not_found(7 * ms));
  EXPECT_FALSE(times.not_found(17 * ms - 1));
  EXPECT_TRUE(times.not_found(17 * ms));
  times.found(18 * ms, 19 * ms);
  EXPECT_FALSE(times.not_found(30 * ms)) << "it begins anew";
  times.reset();
  EXPECT_EQ(times.asked_ns(), 0);
  EXPECT_FALSE(times.not_found(50 * ms));
}

}  // namespace
}  // namespace ghostforce::leap_filter_test
