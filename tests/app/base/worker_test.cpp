// Compiled for both fronts' workers: what their owner can rely on.
#include "app/base/worker.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace ghostforce::worker_test {
namespace {

// What a person's frames are to it; a test that waits in vain is ended by ctest.
template <typename Condition>
void look_until(Worker& worker, Condition&& condition) {
  while (!condition()) {
    worker.poll();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(Worker, MakesStepsUntilOneIsTheLast) {
  int steps = 0;
  Worker worker("steps", 0.0, [&steps] { return ++steps < 5; });
  look_until(worker, [&] { return !worker.is_running(); });
  EXPECT_EQ(steps, 5);
  worker.poll();
  EXPECT_EQ(steps, 5);
}

TEST(Worker, MakesNoneAfterTheEnd) {
  int steps = 0;
  Worker worker("steps", 0.0, [&steps] {
    ++steps;
    return true;
  });
  worker.poll();
  worker.end();
  EXPECT_FALSE(worker.is_running());
  const int made = steps;
  worker.poll();
  worker.end();
  EXPECT_EQ(steps, made);
}

TEST(Worker, WaitsBeforeAStepAndNotForItsEnd) {
  constexpr double an_hour = 3600.0;
  int steps = 0;
  {
    Worker worker("steps", an_hour, [&steps] {
      ++steps;
      return true;
    });
    worker.poll();
    EXPECT_TRUE(worker.is_running());
  }
  EXPECT_EQ(steps, 0);
}

TEST(Worker, TakesItsTimeBetweenSteps) {
  using Clock = std::chrono::steady_clock;
  constexpr double period_s = 0.02;
  const Clock::time_point began = Clock::now();
  int steps = 0;
  Worker worker("steps", period_s, [&steps] { return ++steps < 3; });
  look_until(worker, [&] { return !worker.is_running(); });
  EXPECT_GE(std::chrono::duration<double>(Clock::now() - began).count(), 3 * period_s);
}

}  // namespace
}  // namespace ghostforce::worker_test
