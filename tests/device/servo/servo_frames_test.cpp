// A servo that ticks when a frame is drawn, by a clock of the test's: nothing here waits for time to pass.
#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "device/input/input.h"
#include "device/servo/servo.h"
#include "device/servo/servo_driver.h"
#include "tests/device/servo/servo_scenes.h"
#include "tests/device/servo/servo_steps.h"

namespace ghostforce::servo_frames_test {
namespace {

constexpr std::int64_t ms = 1'000'000;

// A frame after another, at a time that looks like no other.
class Frames {
 public:
  explicit Frames(Servo& servo) : servo_(servo) { servo_.step_to(now_ns_); }

  void draw(int frames, std::int64_t interval_ns) {
    for (int i = 0; i < frames; ++i) servo_.step_to(now_ns_ += interval_ns);
  }

 private:
  Servo& servo_;
  std::int64_t now_ns_ = 777'777'777'777;
};

std::int64_t tick_of(Servo& servo) {
  return servo.newest().snapshot.tick;
}

TEST(ServoFrames, TheFirstStartsTheClock) {
  const Scene scene = slanted_wall();
  Servo servo(script_of(scene), start_of(scene));
  const Frames frames(servo);
  const std::vector<Sample> samples = take_samples(servo);
  ASSERT_EQ(samples.size(), 1U) << "the state that it starts from";
  EXPECT_EQ(samples[0].snapshot.tick, 0);
}

// However long a frame takes: the same ticks as by hand, and all of them.
TEST(ServoFrames, MakeAllTheTicksThatAreDue) {
  const Scene scene = slanted_wall();
  for (const std::int64_t interval_ns : {4 * ms, 10 * ms, 16 * ms, 100 * ms, 150 * ms}) {
    SCOPED_TRACE(interval_ns);
    Servo by_hand(script_of(scene), start_of(scene));
    Servo servo(script_of(scene), start_of(scene));
    Frames frames(servo);
    frames.draw(static_cast<int>(1200 * ms / interval_ns), interval_ns);
    const std::int64_t ticks = 1200 * ms / interval_ns * interval_ns / ms;
    step(by_hand, ticks + 1);
    const std::vector<Sample> samples = take_samples(servo);
    const std::vector<Sample> wanted = take_samples(by_hand);
    ASSERT_EQ(samples.size(), wanted.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      expect_same(samples[i].snapshot, wanted[i].snapshot);
      ASSERT_EQ(samples[i].loop_s, 0.0) << "nobody has measured it";
    }
    EXPECT_EQ(servo.newest().loop.late_ticks, 0U);
    EXPECT_EQ(servo.newest().loop.worst_late_s, 0.0);
    EXPECT_NEAR(servo.newest().loop.rate_hz, 1000.0, 3.0);
  }
}

TEST(ServoFrames, MoreOftenThanTicksMakeNoneTwice) {
  const Scene scene = slanted_wall();
  Servo servo(script_of(scene), start_of(scene));
  Frames frames(servo);
  frames.draw(1000, ms / 4);
  EXPECT_EQ(tick_of(servo), 250);
  frames.draw(10, 0);
  EXPECT_EQ(tick_of(servo), 250);
}

TEST(ServoFrames, WhatAHiddenPageMissesIsLeftOut) {
  const Scene scene = slanted_wall();
  Servo servo(script_of(scene), start_of(scene));
  Frames frames(servo);
  frames.draw(100, 16 * ms);
  ASSERT_EQ(tick_of(servo), 1600);
  const double rate_hz = servo.newest().loop.rate_hz;
  frames.draw(1, 3'600'000 * ms);
  EXPECT_EQ(tick_of(servo), 1750) << "as much as is caught up with";
  EXPECT_EQ(servo.newest().loop.late_ticks, 0U);
  EXPECT_EQ(servo.newest().loop.rate_hz, rate_hz) << "an hour without ticks is no slow loop";
  frames.draw(100, 16 * ms);
  EXPECT_EQ(tick_of(servo), 3350);
  EXPECT_NEAR(servo.newest().loop.rate_hz, 1000.0, 3.0);
}

// A computer that draws four frames a second: the hand goes on, slower, and the rate says so.
TEST(ServoFrames, TooSlowOnesTellTheTrueRate) {
  const Scene scene = slanted_wall();
  Servo servo(script_of(scene), start_of(scene));
  Frames frames(servo);
  frames.draw(40, 250 * ms);
  EXPECT_EQ(tick_of(servo), 40 * 150);
  EXPECT_NEAR(servo.newest().loop.rate_hz, 600.0, 80.0);
}

TEST(ServoFrames, ReadACommandEachTime) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.settings.rate = 10.0;
  Servo servo(script_of(scene), command);
  Frames frames(servo);
  for (int i = 0; i < 20; ++i) {
    ++command.settings_generation;
    servo.send(command);
    frames.draw(1, ms);
    EXPECT_EQ(servo.newest().settings_generation, command.settings_generation);
    EXPECT_EQ(tick_of(servo), 0);
  }
}

TEST(ServoFrames, GoAtTheSpeedThatIsAsked) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.speed = 0.1;
  Servo servo(script_of(scene), command);
  Frames frames(servo);
  frames.draw(100, 16 * ms);
  EXPECT_EQ(tick_of(servo), 160);
  command.speed = 2.0;
  servo.send(command);
  frames.draw(100, 16 * ms);
  EXPECT_NEAR(static_cast<double>(tick_of(servo)), 160.0 + 3200.0, 10.0);
  EXPECT_NEAR(servo.newest().loop.rate_hz, 2000.0, 5.0);
}

TEST(ServoFrames, StandStillWhilePaused) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.paused = true;
  Servo servo(script_of(scene), command);
  Frames frames(servo);
  frames.draw(100, 16 * ms);
  EXPECT_EQ(tick_of(servo), 0);
  EXPECT_EQ(servo.newest().loop.rate_hz, 0.0);
  command.steps_asked = 2;
  servo.send(command);
  frames.draw(1, 16 * ms);
  EXPECT_EQ(tick_of(servo), 2);
  command.paused = false;
  servo.send(command);
  frames.draw(1, 16 * ms);
  EXPECT_LE(tick_of(servo), 2 + 16);
  frames.draw(100, 16 * ms);
  EXPECT_NEAR(static_cast<double>(tick_of(servo)), 2.0 + 16.0 * 101.0, 10.0) << "time paused is not made up for";
}

TEST(ServoFrames, AClockThatGoesBackChangesNothing) {
  const Scene scene = slanted_wall();
  Servo servo(script_of(scene), start_of(scene));
  Frames frames(servo);
  frames.draw(10, 16 * ms);
  frames.draw(1, -100 * ms);
  EXPECT_EQ(tick_of(servo), 160);
  frames.draw(1, 116 * ms);
  EXPECT_EQ(tick_of(servo), 176);
}

// A handle that answers a little after it was asked, with a clock that only waiting moves.
class LaggingInput final : public Input, public HapticDevice {
 public:
  void restart(const Vector<2>& /*goal*/) noexcept override {}
  Vector<2> goal(std::int64_t /*tick*/, double /*rate*/) noexcept override { return Vector<2>(0.0); }
  HapticDevice* haptic_device() noexcept override { return this; }

  std::int64_t now_ns() const noexcept override { return now; }
  void wait_until(std::int64_t deadline_ns) noexcept override {
    const std::int64_t until_ns = deadline_ns + lag_ns;
    if (until_ns > now) longest_gap_ns = std::max(longest_gap_ns, until_ns - now);
    now = std::max(now, until_ns);
  }
  HandleReading read() noexcept override {
    ++reads;
    return {.is_known = true, .time_ns = now, .is_ready = true, .is_healthy = true};
  }
  double force_at_handle() const noexcept override { return 1.0; }
  Vector<2> set_force(const Vector<2>& force, bool /*is_armed*/) noexcept override { return force; }
  double force_uncertainty() const noexcept override { return 1.0; }
  void shut_down() noexcept override { ++shut_downs; }

  std::int64_t now = 1000 * ms;
  std::int64_t lag_ns = ms / 10;
  std::int64_t longest_gap_ns = 0;
  int reads = 0;
  int shut_downs = 0;
};

class ServoFramesOfDevice : public testing::Test {
 protected:
  ServoFramesOfDevice() {
    auto input = std::make_unique<LaggingInput>();
    device = input.get();
    servo = std::make_unique<Servo>(std::move(input), start_of(slanted_wall()));
  }

  LaggingInput* device = nullptr;
  std::unique_ptr<Servo> servo;
};

TEST_F(ServoFramesOfDevice, ItSeesTickAfterTickAPeriodApart) {
  Frames frames(*servo);
  frames.draw(20, 100 * ms);
  EXPECT_EQ(servo->newest().loop.late_ticks, 0U);
  EXPECT_NEAR(static_cast<double>(tick_of(*servo)), 2000.0, 200.0) << "a late answer sets the rhythm";
  EXPECT_NEAR(static_cast<double>(device->now), 3000.0 * ms, 2.0 * ms);
  EXPECT_LE(device->longest_gap_ns, 2 * ms);
}

TEST_F(ServoFramesOfDevice, TimeThatIsLeftOutHasNeverBeen) {
  Frames frames(*servo);
  frames.draw(1, 3'600'000 * ms);
  EXPECT_NEAR(static_cast<double>(device->now), 1150.0 * ms, 2.0 * ms);
  EXPECT_LE(device->longest_gap_ns, 2 * ms);
}

TEST_F(ServoFramesOfDevice, ItLivesOnBetweenVerySlowTicks) {
  ServoCommand command = start_of(slanted_wall());
  command.speed = Servo::slowest;
  servo->send(command);
  Frames frames(*servo);
  frames.draw(10, 100 * ms);
  EXPECT_LE(tick_of(*servo), 10);
  EXPECT_GE(device->reads, 150) << "as often as commands are read";
  EXPECT_LE(device->longest_gap_ns, 6 * ms);
}

TEST_F(ServoFramesOfDevice, IsShutDownWhenNobodyDrivesItAnyLonger) {
  FrameServoDriver driver;
  driver.step(0);  // nothing to drive
  driver.start(*servo);
  driver.start(*servo);
  driver.step(5 * ms);
  driver.step(25 * ms);
  const std::int64_t last = tick_of(*servo);
  EXPECT_GT(last, 10);
  driver.stop();
  EXPECT_EQ(device->shut_downs, 1);
  driver.stop();
  EXPECT_EQ(device->shut_downs, 1) << "once";
  driver.step(45 * ms);
  EXPECT_EQ(tick_of(*servo), last);

  driver.start(*servo);
  driver.step(10'000 * ms);
  EXPECT_EQ(tick_of(*servo), last) << "its clock starts again";
  driver.step(10'020 * ms);
  EXPECT_GT(tick_of(*servo), last + 10);
}

TEST_F(ServoFramesOfDevice, IsShutDownWhenTheDriverGoes) {
  {
    FrameServoDriver driver;
    driver.start(*servo);
    driver.step(0);
  }
  EXPECT_EQ(device->shut_downs, 1);
}

}  // namespace
}  // namespace ghostforce::servo_frames_test
