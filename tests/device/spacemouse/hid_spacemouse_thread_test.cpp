// The three threads that meet in a HidSpaceMouseInput, with whatever is plugged into this machine; mostly nothing.
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "device/spacemouse/hid_spacemouse_input.h"

namespace ghostforce::hid_spacemouse_thread_test {
namespace {

TEST(SpaceMouseThreads, MeetInWholeValues) {
  HidSpaceMouseInput input;
  std::atomic<bool> stop = false;
  std::thread servo([&] {
    input.restart({0.01, 0.02});
    for (int tick = 0; !stop; ++tick) {
      const Vector<2> goal = input.goal(tick, 1000.0);
      EXPECT_TRUE(std::abs(goal.x) <= 1.0 && std::abs(goal.y) <= 1.0);
      std::this_thread::yield();
    }
  });
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(700);  // it looks for a device twice
  while (std::chrono::steady_clock::now() < end) {
    SpaceMouseSettings settings;
    settings.mode = SpaceMouseSettings::Mode::rate;
    EXPECT_TRUE(input.set(settings));
    EXPECT_TRUE(input.set({}));
    const SpaceMouseReading& reading = input.reading();
    EXPECT_EQ(reading.connected(), reading.trouble == SpaceMouseReading::Trouble::none);
    std::this_thread::yield();
  }
  stop = true;
  servo.join();
}

TEST(SpaceMouseThreads, EndAtOnce) {
  for (int i = 0; i < 20; ++i) const HidSpaceMouseInput input;
}

}  // namespace
}  // namespace ghostforce::hid_spacemouse_thread_test
