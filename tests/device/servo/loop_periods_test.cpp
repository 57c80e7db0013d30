// How long the ticks of a loop are apart, by a clock of the test's.
#include "device/report/loop_periods.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "device/servo/servo.h"
#include "tests/device/servo/servo_scenes.h"
#include "tests/device/servo/servo_steps.h"

namespace ghostforce::loop_periods_test {
namespace {

constexpr std::int64_t us = 1'000;
constexpr std::int64_t ms = 1'000'000;
constexpr std::size_t millisecond_bin = 9;

TEST(LoopPeriods, CountsEachWhereItsBinBeginsAndEnds) {
  LoopPeriods periods;
  for (std::size_t bin = 1; bin < LoopPeriods::bin_count; ++bin) {
    const double edge_s = LoopPeriods::begin_of(bin);
    periods = {};
    periods.add(edge_s * (1.0 - 1e-9), false);
    EXPECT_EQ(periods.count(bin - 1), 1U) << bin;
    periods.add(edge_s * (1.0 + 1e-9), false);
    EXPECT_EQ(periods.count(bin), 1U) << bin;
  }
  periods = {};
  for (const double period_s : {0.0, 1e-9, 1.0, 1e9}) periods.add(period_s, false);
  EXPECT_EQ(periods.count(0), 2U);
  EXPECT_EQ(periods.count(LoopPeriods::bin_count - 1), 2U);
  EXPECT_LT(LoopPeriods::begin_of(millisecond_bin), 0.0009);
  EXPECT_GT(LoopPeriods::begin_of(millisecond_bin + 1), 0.0011);
}

TEST(LoopPeriods, KnowsTheMeanTheWorstAndTheShareThatWasLate) {
  LoopPeriods periods;
  EXPECT_EQ(periods.mean_hz(), 0.0);
  EXPECT_EQ(periods.late_share(), 0.0);
  for (int i = 0; i < 3; ++i) periods.add(0.001, false);
  periods.add(0.005, true);
  EXPECT_EQ(periods.ticks(), 4U);
  EXPECT_EQ(periods.late_ticks(), 1U);
  EXPECT_DOUBLE_EQ(periods.mean_hz(), 500.0);
  EXPECT_EQ(periods.worst_s(), 0.005);
  EXPECT_EQ(periods.late_share(), 0.25);
}

// A thread that wakes the servo, and comes when the test wants it to.
class Woken {
 public:
  explicit Woken(Servo& servo) : servo_(servo) { servo_.begin(now_ns_); }

  void wake_after(std::int64_t ns) { servo_.wake(now_ns_ += ns); }
  void keep_time(int ticks) {
    for (int i = 0; i < ticks; ++i) wake_after(servo_.next_wake().time_ns - now_ns_);
  }

 private:
  Servo& servo_;
  std::int64_t now_ns_ = 777'777'777'777;
};

TEST(LoopPeriods, OfAServoTellWhenItsTicksCame) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(script_of(scene), command);
  Woken thread(servo);
  const auto periods = [&]() -> const LoopPeriods& { return servo.newest().loop.periods; };
  thread.keep_time(101);
  EXPECT_EQ(periods().ticks(), 100U) << "the first has none before it";
  EXPECT_EQ(periods().count(millisecond_bin), 100U);
  EXPECT_EQ(periods().late_ticks(), 0U);
  EXPECT_NEAR(periods().mean_hz(), 1000.0, 1e-6);

  thread.wake_after(3 * ms + 200 * us);
  EXPECT_EQ(periods().late_ticks(), 1U);
  EXPECT_NEAR(periods().worst_s(), 0.0032, 1e-12);
  EXPECT_EQ(periods().count(12), 1U);
  thread.keep_time(10);
  EXPECT_EQ(periods().late_ticks(), 1U);

  // While nothing is to be paced, and while model time does not run as real time does, nothing is counted.
  const std::uint64_t before = periods().ticks();
  command.paused = true;
  servo.send(command);
  thread.keep_time(20);
  const std::uint64_t when_paused = periods().ticks();
  EXPECT_LE(when_paused, before + 1);
  command.paused = false;
  command.speed = 0.25;
  servo.send(command);
  thread.keep_time(20);
  EXPECT_EQ(periods().ticks(), when_paused);
  command.speed = 1.0;
  servo.send(command);
  thread.keep_time(20);
  EXPECT_GT(periods().ticks(), when_paused);
  EXPECT_NEAR(periods().worst_s(), 0.0032, 1e-12);
}

TEST(LoopPeriods, AreUnknownWhereNoRealTimeIsMeasured) {
  const Scene scene = slanted_wall();
  Servo servo(script_of(scene), start_of(scene));
  for (std::int64_t now = 0; now < 1000 * ms; now += 16 * ms) servo.step_to(now + ms);
  step(servo, 10);
  EXPECT_EQ(servo.newest().loop.periods.ticks(), 0U);
}

}  // namespace
}  // namespace ghostforce::loop_periods_test
