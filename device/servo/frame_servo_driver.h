// FrameServoDriver: makes the ticks of each frame when the frame comes, for a program without threads. See
// Servo::step_to() for what a device must be like. UI thread, which is the servo thread too.
#pragma once

#include "device/servo/servo.h"
#include "device/servo/servo_driver.h"

namespace ghostforce {

class FrameServoDriver final : public ServoDriver {
 public:
  FrameServoDriver() = default;
  ~FrameServoDriver() override { FrameServoDriver::stop(); }

  void start(Servo& servo) override { servo_ = &servo; }
  void stop() noexcept override {
    if (servo_ != nullptr) servo_->shut_down();
    servo_ = nullptr;
  }
  void step(std::int64_t now_ns) noexcept override {
    if (servo_ != nullptr) servo_->step_to(now_ns);
  }

 private:
  Servo* servo_ = nullptr;
};

}  // namespace ghostforce
