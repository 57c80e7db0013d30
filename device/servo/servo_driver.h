// ServoDriver: who makes a servo tick as time goes on. The window's program hands one in: a thread of its own on a
// desktop (servo_thread.h), the frames themselves in a page, which has no threads (FrameServoDriver). UI thread.
#pragma once

#include <cstdint>

#include "device/servo/servo.h"

namespace ghostforce {

class ServoDriver {
 public:
  ServoDriver() = default;
  ServoDriver(const ServoDriver&) = delete;
  ServoDriver& operator=(const ServoDriver&) = delete;
  virtual ~ServoDriver() = default;  // stops

  // From now on `servo` ticks; it must not go before stop(). Another one only after that. May throw.
  virtual void start(Servo& servo) = 0;
  // The servo ticks no more: its motors are off, and its device has been told. start() may follow.
  virtual void stop() noexcept = 0;
  // Once a frame. `now_ns`: by any clock that goes with real time.
  virtual void step(std::int64_t /*now_ns*/) noexcept {}
};

// Makes the ticks of each frame when the frame comes, for a program without threads: the UI thread is the servo thread
// too. See Servo::step_to() for what a device must be like.
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
