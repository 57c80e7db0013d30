#include "device/servo/servo_thread.h"

#include <gtest/gtest.h>

namespace ghostforce::latency_histogram_test {
namespace {

TEST(LatencyHistogram, KnowsNothingWithoutTicks) {
  const LatencyHistogram latency_histogram;
  EXPECT_EQ(latency_histogram.ticks(), 0U);
  EXPECT_EQ(latency_histogram.percentile_ns(0.5), 0);
  EXPECT_EQ(latency_histogram.worst_ns(), 0);
}

TEST(LatencyHistogram, ReadsPercentilesOfWhatWasAdded) {
  LatencyHistogram latency_histogram;
  for (std::int64_t k = 1; k <= 50; ++k) latency_histogram.add(k);
  EXPECT_EQ(latency_histogram.percentile_ns(0.0), 1);
  EXPECT_EQ(latency_histogram.percentile_ns(0.5), 25);
  EXPECT_EQ(latency_histogram.percentile_ns(0.98), 49);
  EXPECT_EQ(latency_histogram.percentile_ns(0.981), 50);
  EXPECT_EQ(latency_histogram.percentile_ns(1.0), 50);
}

// At every place of the scale: never less than what was added, and never more by over 1/32.
TEST(LatencyHistogram, IsTrueToOnePartIn32) {
  for (std::int64_t late = 1; late < 17'000'000'000; late += 1 + late / 7) {
    LatencyHistogram latency_histogram;
    latency_histogram.add(late, 99);
    latency_histogram.add(16'900'000'000);
    EXPECT_GE(latency_histogram.percentile_ns(0.99), late);
    EXPECT_LE(latency_histogram.percentile_ns(0.99) - late, late / 32) << late;
  }
}

TEST(LatencyHistogram, KeepsWhatIsOffTheScale) {
  LatencyHistogram latency_histogram;
  latency_histogram.add(-5, 3);
  EXPECT_EQ(latency_histogram.percentile_ns(1.0), 0);
  constexpr std::int64_t day_ns = 86'400'000'000'000;
  latency_histogram.add(day_ns);
  EXPECT_EQ(latency_histogram.worst_ns(), day_ns);
  EXPECT_EQ(latency_histogram.ticks(), 4U);
  EXPECT_GT(latency_histogram.percentile_ns(1.0), 17'000'000'000);
}

}  // namespace
}  // namespace ghostforce::latency_histogram_test
