#include "device/servo/latency_histogram.h"

#include <gtest/gtest.h>

namespace ghostforce {
namespace {

TEST(Lateness, KnowsNothingWithoutTicks) {
  const Lateness lateness;
  EXPECT_EQ(lateness.ticks(), 0U);
  EXPECT_EQ(lateness.percentile_ns(0.5), 0);
  EXPECT_EQ(lateness.worst_ns(), 0);
}

TEST(Lateness, ReadsPercentilesOfWhatWasAdded) {
  Lateness lateness;
  for (std::int64_t k = 1; k <= 50; ++k) lateness.add(k);
  EXPECT_EQ(lateness.percentile_ns(0.0), 1);
  EXPECT_EQ(lateness.percentile_ns(0.5), 25);
  EXPECT_EQ(lateness.percentile_ns(0.98), 49);
  EXPECT_EQ(lateness.percentile_ns(0.981), 50);
  EXPECT_EQ(lateness.percentile_ns(1.0), 50);
}

// At every place of the scale: never less than what was added, and never more by over 1/32.
TEST(Lateness, IsTrueToOnePartIn32) {
  for (std::int64_t late = 1; late < 17'000'000'000; late += 1 + late / 7) {
    Lateness lateness;
    lateness.add(late, 99);
    lateness.add(16'900'000'000);
    EXPECT_GE(lateness.percentile_ns(0.99), late);
    EXPECT_LE(lateness.percentile_ns(0.99) - late, late / 32) << late;
  }
}

TEST(Lateness, KeepsWhatIsOffTheScale) {
  Lateness lateness;
  lateness.add(-5, 3);
  EXPECT_EQ(lateness.percentile_ns(1.0), 0);
  constexpr std::int64_t day_ns = 86'400'000'000'000;
  lateness.add(day_ns);
  EXPECT_EQ(lateness.worst_ns(), day_ns);
  EXPECT_EQ(lateness.ticks(), 4U);
  EXPECT_GT(lateness.percentile_ns(1.0), 17'000'000'000);
}

}  // namespace
}  // namespace ghostforce
