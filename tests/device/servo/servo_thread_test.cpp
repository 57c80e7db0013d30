// The servo's real thread. That it does what it should, not how punctually: a loaded machine fails none of these. They
// run under the thread sanitizer too.
#include <atomic>
#include <chrono>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"
#include "device/servo/servo.h"
#include "device/servo/servo_thread.h"
#include "tests/device/servo/servo_scenes.h"

namespace ghostforce::servo_thread_test {
namespace {

// Until it is so; a test that waits in vain is ended by ctest.
template <typename Condition>
void wait_until(Condition&& condition) {
  while (!condition()) std::this_thread::sleep_for(std::chrono::microseconds(200));
}

TEST(ServoThread, TicksUntilItIsStopped) {
  const Scene scene = slanted_wall();
  Servo servo(std::make_unique<ScriptedInput>(scene.goal), start_of(scene));
  ServoThread thread;
  thread.start(servo);
  thread.start(servo);  // changes nothing
  wait_until([&] { return servo.newest().snapshot.tick >= 100; });
  thread.stop();
  const std::int64_t last = servo.newest().snapshot.tick;
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(servo.newest().snapshot.tick, last);
  std::int64_t k = 0;
  for (const Sample& sample : take_samples(servo)) EXPECT_EQ(sample.snapshot.tick, k++);
  EXPECT_EQ(k, last + 1);

  thread.start(servo);
  wait_until([&] { return servo.newest().snapshot.tick >= last + 10; });
}  // and the destructor stops it

// At 20 to 5000 ticks per second of real time it must make the ticks that the time allows, and may make fewer.
TEST(ServoThread, NeverTicksFasterThanAsked) {
  const Scene scene = slanted_wall();
  for (const double speed : {0.02, 0.2, 1.0, 5.0}) {
    ServoCommand command = start_of(scene);
    command.speed = speed;
    Servo servo(std::make_unique<ScriptedInput>(scene.goal), command);
    ServoThread thread;
    const auto start = std::chrono::steady_clock::now();
    thread.start(servo);
    wait_until([&] { return servo.newest().snapshot.tick >= 3; });
    thread.stop();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_LE(static_cast<double>(servo.newest().snapshot.tick), took.count() * scene.settings.rate * speed + 1.0);
  }
}

TEST(ServoThread, HeedsCommandsButDoesNotTickWhilePaused) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.paused = true;
  Servo servo(std::make_unique<ScriptedInput>(scene.goal), command);
  ServoThread thread;
  thread.start(servo);
  for (command.settings_generation = 1; command.settings_generation <= 10; ++command.settings_generation) {
    servo.send(command);
    wait_until([&] { return servo.newest().settings_generation == command.settings_generation; });
    EXPECT_EQ(servo.newest().snapshot.tick, 0);
  }
  command.steps_asked = 2;
  servo.send(command);
  wait_until([&] { return servo.newest().snapshot.tick == 2; });
  EXPECT_EQ(servo.newest().loop.late_ticks, 0U);
  EXPECT_EQ(servo.newest().loop.rate_hz, 0.0);
}

TEST(ServoThread, HeedsCommandsBetweenVerySlowTicks) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.settings.rate = 10.0;
  command.speed = Servo::slowest;  // a tick in 100 s
  Servo servo(std::make_unique<ScriptedInput>(scene.goal), command);
  ServoThread thread;
  thread.start(servo);
  command.settings_generation = 1;
  servo.send(command);
  wait_until([&] { return servo.newest().settings_generation == 1; });
  EXPECT_EQ(servo.newest().snapshot.tick, 0);
  command.speed = 10.0;
  servo.send(command);
  wait_until([&] { return servo.newest().snapshot.tick >= 3; });
  thread.stop();
}

TEST(ServoThread, HoldsSpeedsWithinReason) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.settings.rate = 20000.0;
  command.speed = 1e-300;
  Servo servo(std::make_unique<ScriptedInput>(scene.goal), command);
  ServoThread thread;
  auto start = std::chrono::steady_clock::now();
  const auto seconds = [&start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  thread.start(servo);
  for (command.settings_generation = 1; command.settings_generation <= 5; ++command.settings_generation) {
    servo.send(command);
    wait_until([&] { return servo.newest().settings_generation == command.settings_generation; });
  }
  thread.stop();
  const std::int64_t slow_tick = servo.newest().snapshot.tick;
  EXPECT_LE(static_cast<double>(slow_tick), seconds() * command.settings.rate * Servo::slowest + 1.0);

  command.speed = 1e300;
  servo.send(command);
  start = std::chrono::steady_clock::now();
  thread.start(servo);
  wait_until([&] { return servo.newest().snapshot.tick >= slow_tick + 500; });
  thread.stop();
  const auto ticks = static_cast<double>(servo.newest().snapshot.tick - slow_tick);
  EXPECT_LE(ticks, seconds() / Servo::shortest_period_s + 1.0);
  EXPECT_EQ(servo.newest().refused_commands, 0U);
}

// The recorder's thread beside the window's: each gets every sample.
TEST(ServoThread, HandsEverySampleToTheRecorderToo) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.recording = 7;
  Servo servo(std::make_unique<ScriptedInput>(scene.goal), command);
  ServoThread thread;
  thread.start(servo);
  std::vector<Sample> records;
  std::atomic<bool> has_enough{false};
  std::thread recorder([&] {
    while (records.size() < 300) {
      for (Sample sample; servo.take_record(sample);) records.push_back(sample);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    has_enough = true;
  });
  std::vector<Sample> samples;
  wait_until([&] {
    for (Sample sample; servo.take_sample(sample);) samples.push_back(sample);
    servo.send(command);
    return has_enough.load();
  });
  recorder.join();
  thread.stop();
  for (Sample sample; servo.take_sample(sample);) samples.push_back(sample);
  ASSERT_LE(records.size(), samples.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    ASSERT_EQ(records[i].serial, i);
    ASSERT_EQ(records[i].recording, 7U);
    ASSERT_EQ(records[i].snapshot.tick, samples[i].snapshot.tick);
    ASSERT_EQ(records[i].velocity, samples[i].velocity);
    ASSERT_EQ(records[i].settings, scene.settings);
    ASSERT_EQ(records[i].loop_s > 0.0, i > 0) << "real time goes on";
  }
  EXPECT_EQ(servo.newest().loop.dropped_records, 0U);
}

TEST(ServoThread, SaysWhatRealtimeConditionsItGot) {
  const Scene scene = slanted_wall();
  Servo servo(std::make_unique<ScriptedInput>(scene.goal), start_of(scene));
  ServoThread thread;
  thread.start(servo);
  wait_until([&] { return servo.newest().snapshot.tick >= 1; });
  EXPECT_FALSE(describe(servo.newest().realtime).empty());
}

// The window at its wildest: every exchange, as fast as it can, for some hundred ticks.
TEST(ServoThread, ExchangesWholeValuesWithTheWindow) {
  std::mt19937 random(1);
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  Servo servo(std::make_unique<MouseInput>(), command);
  ServoThread thread;
  auto& mouse = dynamic_cast<MouseInput&>(servo.input());
  thread.start(servo);

  std::uint64_t samples = 0;
  std::uint64_t reports = 0;
  std::uint32_t generation_before = 0;
  Sample before;
  before.snapshot.tick = -1;
  while (samples < 500 || reports < 100) {
    const auto dice = static_cast<std::uint32_t>(random());
    mouse.move_to({(dice % 80) * 1e-3 - 0.04, (dice / 80 % 80) * 1e-3 - 0.04}, 0.016);
    command.settings.wall_normal_angle = dice % 628 * 0.01;
    ++command.settings_generation;
    if (dice % 10'000 == 0) {
      ++command.restarts_asked;
      command.restart_state = state_at_start(Vector<2>(0.001 * (command.restarts_asked % 40), 0.02));
    }
    command.speed = dice % 3 == 0 ? 2.0 : 1.0;
    servo.send(command);

    const ServoReport& report = servo.newest();
    ++reports;
    ASSERT_GE(report.settings_generation, generation_before);
    ASSERT_LE(report.settings_generation, command.settings_generation);
    ASSERT_LE(report.restarts, command.restarts_asked);
    ASSERT_EQ(report.refused_commands, 0U);
    ASSERT_TRUE(is_finite(report.snapshot));
    generation_before = report.settings_generation;

    for (Sample sample; servo.take_sample(sample); ++samples) {
      if (sample.restarts == before.restarts) {
        ASSERT_EQ(sample.snapshot.tick, before.snapshot.tick + 1);
      } else {
        ASSERT_GT(sample.restarts, before.restarts);
        ASSERT_EQ(sample.snapshot.tick, 0);
        // Made on this side, seen on that one.
        ASSERT_EQ(sample.snapshot.goal, Vector<2>(0.001 * (sample.restarts % 40), 0.02));
      }
      ASSERT_EQ(sample.snapshot.time_s, time_of(sample.snapshot.tick, scene.settings.rate));
      before = sample;
    }
  }
  thread.stop();
  EXPECT_GT(generation_before, 0U);
  EXPECT_EQ(servo.newest().loop.dropped_samples, 0U);
}

}  // namespace
}  // namespace ghostforce::servo_thread_test
