#include "device/servo/servo_thread.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace ghostforce::hybrid_sleep_test {
namespace {

constexpr std::int64_t us = 1'000;
constexpr std::int64_t ms = 1'000'000;

// A machine on which looking at the clock takes 30 ns and a sleeper is woken as late as it says.
struct FakeClock {
  std::int64_t time_ns = 0;
  std::int64_t oversleeps_ns = 0;
  std::int64_t asleep_ns = 0;

  std::int64_t now_ns() noexcept { return time_ns += 30; }
  void sleep_until(std::int64_t until_ns) noexcept {
    const std::int64_t woken_ns = std::max(time_ns, until_ns + oversleeps_ns);
    asleep_ns += woken_ns - time_ns;
    time_ns = woken_ns;
  }
};

// Ticks of 2 µs, one per period. `oversleeps` tells for each how late it will be woken [ns].
struct Loop {
  std::int64_t period_ns = ms;
  FakeClock clock{};
  HybridSleep sleep{period_ns};
  std::int64_t deadline_ns = 0;
  std::int64_t longest_spin_ns = 0;
  std::vector<std::int64_t> late_ns{};

  template <typename Oversleeps>
  void run(int ticks, Oversleeps&& oversleeps) {
    late_ns.clear();
    for (int k = 0; k < ticks; ++k) {
      deadline_ns += period_ns;
      clock.oversleeps_ns = oversleeps();
      const std::int64_t slept_before_ns = clock.asleep_ns;
      const std::int64_t began_ns = clock.time_ns;
      const std::int64_t over_ns = sleep.until(deadline_ns, clock);
      longest_spin_ns = std::max(longest_spin_ns, over_ns - began_ns - (clock.asleep_ns - slept_before_ns));
      late_ns.push_back(over_ns - deadline_ns);
      clock.time_ns += 2 * us;
      while (deadline_ns + period_ns <= clock.time_ns) deadline_ns += period_ns;
    }
  }

  // Of those of the last run() [ns].
  std::int64_t percentile(double share) {
    std::ranges::sort(late_ns);
    return late_ns[static_cast<std::size_t>(share * static_cast<double>(late_ns.size() - 1))];
  }

  double awake_share() const { return 1.0 - static_cast<double>(clock.asleep_ns) / static_cast<double>(clock.time_ns); }
};

TEST(HybridSleep, MeetsDeadlinesThatASleeperWouldMiss) {
  Loop loop;
  loop.run(1000, [] { return 25 * us; });
  EXPECT_LE(loop.percentile(1.0), 30);
}

TEST(HybridSleep, NeverReturnsBeforeTheDeadline) {
  std::mt19937 random(1);
  Loop loop;
  // Woken up to 300 µs too soon or too late.
  loop.run(20'000, [&random] { return static_cast<std::int64_t>(random() % (600 * us)) - 300 * us; });
  EXPECT_GE(loop.percentile(0.0), 0);
}

TEST(HybridSleep, SpinsNoLongerThanItsWakeUpsNeed) {
  Loop loop;
  loop.run(1, [] { return 5 * us; });
  const std::int64_t at_first_ns = loop.sleep.margin_ns();
  loop.run(60'000, [] { return 5 * us; });
  EXPECT_LT(loop.sleep.margin_ns(), 15 * us);
  EXPECT_GT(loop.sleep.margin_ns(), 1 * us);
  EXPECT_GT(at_first_ns, 30 * us);
  EXPECT_LE(loop.percentile(0.99), 30);
}

TEST(HybridSleep, WakesSoonerOnAMachineThatWakesLate) {
  Loop loop;
  loop.run(5000, [] { return 200 * us; });
  loop.run(1000, [] { return 200 * us; });
  EXPECT_LE(loop.percentile(0.99), 30) << "200 µs asleep cost nothing";
  EXPECT_GT(loop.sleep.margin_ns(), 200 * us);
}

// However wake-ups are spread, the thread is awake for no more than its share and the ticks' own 2 µs.
TEST(HybridSleep, StaysWithinItsShareOfTheProcessor) {
  for (const std::int64_t period_ns : {10 * ms, ms, ms / 4, ms / 20}) {
    for (const std::int64_t most_ns : {1 * us, 20 * us, 100 * us, 500 * us, 3 * ms}) {
      SCOPED_TRACE(period_ns);
      SCOPED_TRACE(most_ns);
      std::mt19937 random(2);
      Loop loop{.period_ns = period_ns};
      // Mostly at once, every tenth time up to `most_ns` late: the mean of what is overslept says little.
      loop.run(50'000, [&] { return random() % 10 == 0 ? static_cast<std::int64_t>(random()) % most_ns : 0; });
      EXPECT_LE(loop.awake_share(),
                1.1 * HybridSleep::greatest_share + static_cast<double>(2 * us + 120) / static_cast<double>(period_ns));
      EXPECT_LE(static_cast<double>(loop.longest_spin_ns),
                HybridSleep::greatest_margin * static_cast<double>(period_ns) + 60.0);
    }
  }
}

// It is always too late then, so there is nothing to be spun.
TEST(HybridSleep, DoesNotSpinWhereItAlwaysOversleeps) {
  Loop loop;
  loop.run(1000, [] { return 700 * us; });
  loop.longest_spin_ns = 0;
  loop.run(1000, [] { return 700 * us; });
  EXPECT_LE(loop.longest_spin_ns, 60);
  EXPECT_LE(static_cast<double>(loop.sleep.margin_ns()), HybridSleep::greatest_margin * ms);
}

TEST(HybridSleep, SleepsThroughALongPeriod) {
  Loop loop{.period_ns = 1000 * ms};
  loop.run(100, [] { return 10 * us; });
  EXPECT_LE(loop.longest_spin_ns, HybridSleep::greatest_mean_spin_ns);
}

TEST(HybridSleep, BeginsAnewWithAnotherPeriod) {
  HybridSleep sleep(ms);
  HybridSleep same(ms);
  sleep.set_period(ms / 4);
  EXPECT_LT(sleep.margin_ns(), ms / 16);
  FakeClock clock;
  clock.oversleeps_ns = 200 * us;
  for (std::int64_t k = 1; k < 100; ++k) same.until(k * ms, clock);
  const std::int64_t margin_ns = same.margin_ns();
  same.set_period(ms);
  EXPECT_EQ(same.margin_ns(), margin_ns) << "the same period changes nothing";
}

TEST(HybridSleep, DeadlinesThatHavePassedTakeNoTime) {
  HybridSleep sleep(ms);
  FakeClock clock{.time_ns = 5 * ms};
  EXPECT_EQ(sleep.until(4 * ms, clock), 5 * ms + 30);
  EXPECT_EQ(clock.asleep_ns, 0);
}

}  // namespace
}  // namespace ghostforce::hybrid_sleep_test
