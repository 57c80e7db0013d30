#include "device/servo/pacer.h"

#include <gtest/gtest.h>

namespace ghostforce::pacer_test {
namespace {

constexpr std::int64_t start_ns = 5'000'000'000;
constexpr std::int64_t ms = 1'000'000;

TEST(Pacer, IsDueOncePerDeadline) {
  Pacer pacer(start_ns, 0.001);
  EXPECT_FALSE(pacer.is_due(start_ns));
  EXPECT_FALSE(pacer.is_due(start_ns + ms - 1));
  EXPECT_TRUE(pacer.is_due(start_ns + ms));
  EXPECT_FALSE(pacer.is_due(start_ns + ms));
  EXPECT_TRUE(pacer.is_due(start_ns + 2 * ms));
}

TEST(Pacer, DeadlinesDoNotDependOnHowLateTheThreadWas) {
  Pacer pacer(start_ns, 0.001);
  for (std::int64_t k = 1; k <= 100; ++k) {
    EXPECT_EQ(pacer.deadline_ns(), start_ns + k * ms);
    EXPECT_TRUE(pacer.is_due(start_ns + k * ms + 300'000));
  }
  EXPECT_EQ(pacer.late_ticks(), 0U);
  EXPECT_DOUBLE_EQ(pacer.worst_late_s(), 300e-6);
}

// 3 kHz has no whole number of nanoseconds; summing up rounded periods would lose 1 ms in about an hour.
TEST(Pacer, DoesNotDrift) {
  Pacer pacer(start_ns, 1.0 / 3000.0);
  for (int k = 1; k < 3 * 3600; ++k) ASSERT_TRUE(pacer.is_due(pacer.deadline_ns()));
  EXPECT_EQ(pacer.deadline_ns(), start_ns + std::int64_t{3'600'000'000'000} / 1000);
}

TEST(Pacer, SkipsAndCountsDeadlinesThatHavePassed) {
  Pacer pacer(start_ns, 0.001);
  EXPECT_TRUE(pacer.is_due(start_ns + 4 * ms + ms / 2));  // deadlines 2, 3 and 4 are missed, 1 is kept late
  EXPECT_EQ(pacer.late_ticks(), 3U);
  EXPECT_DOUBLE_EQ(pacer.worst_late_s(), 0.0035);
  EXPECT_FALSE(pacer.is_due(start_ns + 4 * ms + ms / 2)) << "no burst";
  EXPECT_EQ(pacer.deadline_ns(), start_ns + 5 * ms) << "still on the grid";
}

TEST(Pacer, SurvivesAThreadThatWasStoppedForADay) {
  Pacer pacer(start_ns, 1.0 / 20000.0);
  constexpr std::int64_t day_ns = std::int64_t{86'400} * 1000 * ms;
  EXPECT_TRUE(pacer.is_due(start_ns + day_ns));
  EXPECT_EQ(pacer.late_ticks(), 86'400U * 20'000U - 1U);
  EXPECT_FALSE(pacer.is_due(start_ns + day_ns));
  EXPECT_EQ(pacer.deadline_ns(), start_ns + day_ns + 50'000);
}

TEST(Pacer, TimeThatIsLeftOutSkipsNothing) {
  Pacer pacer(start_ns, 0.001);
  EXPECT_TRUE(pacer.is_due(start_ns + ms));
  pacer.leave_out(1000 * ms);
  EXPECT_EQ(pacer.deadline_ns(), start_ns + 1002 * ms);
  EXPECT_FALSE(pacer.is_due(start_ns + 1002 * ms - 1));
  EXPECT_TRUE(pacer.is_due(start_ns + 1002 * ms));
  EXPECT_EQ(pacer.late_ticks(), 0U);
  EXPECT_EQ(pacer.worst_late_s(), 0.0);
}

// Ten ticks, and then nobody was there.
TEST(Pacer, OnlyALittleOfWhatIsLeftOutIsPartOfTheRate) {
  for (const std::int64_t left_out_ns : {100 * ms, 10'000 * ms}) {
    Pacer pacer(start_ns, 0.001);
    for (int k = 0; k < 10; ++k) ASSERT_TRUE(pacer.is_due(pacer.deadline_ns()));
    pacer.leave_out(left_out_ns);
    while (pacer.rate_hz() == 0.0) ASSERT_TRUE(pacer.is_due(pacer.deadline_ns()));
    EXPECT_NEAR(pacer.rate_hz(), left_out_ns == 100 * ms ? 800.0 : 1000.0, 1e-6);
  }
}

TEST(Pacer, AnotherPeriodGoesOnFromTheLastDeadline) {
  Pacer pacer(start_ns, 0.001);
  EXPECT_TRUE(pacer.is_due(start_ns + ms + 200'000));
  pacer.set_period(0.010, start_ns + ms + 300'000);
  EXPECT_EQ(pacer.deadline_ns(), start_ns + 11 * ms);
  pacer.set_period(0.010, start_ns + 5 * ms);
  EXPECT_EQ(pacer.deadline_ns(), start_ns + 11 * ms) << "the same period changes nothing";
}

TEST(Pacer, AMuchShorterPeriodIsNotLate) {
  Pacer pacer(start_ns, 100.0);
  pacer.set_period(0.001, start_ns + 40'000 * ms);
  EXPECT_EQ(pacer.deadline_ns(), start_ns + 40'000 * ms);
  EXPECT_TRUE(pacer.is_due(start_ns + 40'000 * ms));
  EXPECT_EQ(pacer.late_ticks(), 0U);
}

TEST(Pacer, AlignsAfterAPause) {
  Pacer pacer(start_ns, 0.001);
  pacer.align(start_ns + 100 * ms);
  EXPECT_FALSE(pacer.is_due(start_ns + 100 * ms));
  EXPECT_TRUE(pacer.is_due(start_ns + 101 * ms));
  EXPECT_EQ(pacer.late_ticks(), 0U);
}

TEST(Pacer, MeasuresTheRateOfTicksThatWereMade) {
  Pacer pacer(start_ns, 0.001);
  EXPECT_EQ(pacer.rate_hz(), 0.0);
  for (std::int64_t k = 2; k <= 600; k += 2)
    ASSERT_TRUE(pacer.is_due(start_ns + k * ms));  // every second one is missed
  EXPECT_DOUBLE_EQ(pacer.rate_hz(), 500.0);
  pacer.align(start_ns + 600 * ms);
  EXPECT_EQ(pacer.rate_hz(), 0.0);
}

}  // namespace
}  // namespace ghostforce::pacer_test
