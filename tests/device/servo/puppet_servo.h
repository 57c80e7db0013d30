// A servo with motors, stepped by hand on a device that does exactly as it is told. For tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/proxy.h"
#include "device/servo/servo.h"
#include "tests/device/servo/motor_settings.h"

namespace ghostforce {

inline constexpr double puppet_dt = 0.001;

// A handle that is where it is put, with a clock that only waiting moves.
class PuppetInput final : public Input, public HapticDevice {
 public:
  void restart(const Vector<2>& /*goal*/) noexcept override {}
  Vector<2> goal(std::int64_t /*tick*/, double /*rate*/) noexcept override { return reading.position; }
  HapticDevice* haptic_device() noexcept override { return this; }

  std::int64_t now_ns() const noexcept override { return now; }
  void wait_until(std::int64_t deadline_ns) noexcept override {
    now = deadline_ns;
    if (answers) reading.time_ns = now;
  }
  HandleReading read() noexcept override { return reading; }
  double force_at_handle() const noexcept override { return gain; }
  Vector<2> set_force(const Vector<2>& force, bool is_armed) noexcept override {
    pushed = force;
    armed = is_armed;
    return force;
  }
  double force_uncertainty() const noexcept override { return uncertainty; }
  void shut_down() noexcept override { pushed = Vector<2>(0.0), armed = false, finished = true; }

  HandleReading reading{.is_known = true, .is_ready = true, .is_healthy = true};
  std::int64_t now = 1'000'000'000;
  bool answers = true;
  double uncertainty = 1.0;
  double gain = 1.0;
  Vector<2> pushed{0.0};
  bool armed = false;
  bool finished = false;
};

// A level wall through the origin, free above; motors along x.
class PuppetServo : public testing::Test {
 protected:
  PuppetServo() { begin(); }

  void begin() {
    auto input = std::make_unique<PuppetInput>();
    puppet_ = input.get();
    command_ = {};
    command_.settings = motor_settings(StrategyId::anisotropic);
    command_.settings.wall_normal_angle = std::acos(-1.0) * 0.75;
    command_.restart_state = state_at_start(outside);
    puppet_->reading.position = outside;
    servo_ = std::make_unique<Servo>(std::move(input), command_);
  }

  const ServoReport& report() { return servo_->newest(); }
  const MotorReport& motors() { return report().motors; }

  // The window lives and sends its newest.
  void step() {
    ++command_.heartbeats;
    servo_->send(command_);
    servo_->step();
  }
  void run(double seconds) {
    for (double t = 0.0; t < seconds - 0.5 * puppet_dt; t += puppet_dt) step();
  }
  void arm() { ++command_.arms_asked; }
  void turn_on() {
    arm();
    run(1.1);
    ASSERT_EQ(motors().state, SafetyState::on);
  }
  // What the active strategy wants with the handle there.
  Vector<2> wanted(const Vector<2>& handle, const Settings& settings) const {
    const TickCoefficients<2> coefficients = coefficients_of(settings);
    const auto& active = coefficients.strategies[index_of(settings.active)];
    return active.rendering * (proxy_of(handle, coefficients.wall, active.proxy_gain).position - handle);
  }

  static constexpr Vector<2> outside{-0.02, 0.02};
  static constexpr Vector<2> inside{0.006, -0.006};
  PuppetInput* puppet_ = nullptr;
  ServoCommand command_;
  std::unique_ptr<Servo> servo_;
};

}  // namespace ghostforce
