// A rehearsal stepped by hand: servo, driver and virtual Falcon, with a clock that only the servo's waiting moves. Tick
// by tick, or frame by frame with all the ticks that are due by then.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "core/scene.h"
#include "device/servo/servo.h"
#include "device/virtual_falcon/virtual_falcon_input.h"
#include "tests/device/servo/motor_settings.h"

namespace ghostforce {

// A 45° wall through the middle, free on the upper left; motor along x; the hand of the paper's experiment.
inline Settings rehearsal_settings() {
  Settings settings = motor_settings(StrategyId::naive);
  settings.wall_normal_angle = 0.75 * std::acos(-1.0);
  return settings;
}

inline Scene rehearsal_scene() {
  Scene scene;
  scene.settings.stiffnesses.k_u = 100.0;
  return scene;
}

// The same hand, no longer still.
inline Scene restless_scene() {
  Scene scene = rehearsal_scene();
  scene.stiffness_path = {{100.0, 400.0}, {0.0, 12.0}};
  scene.tremor_and_drift = {.tremor_rms = 0.0002, .drift_speed = 0.004, .seed = 2.0};
  return scene;
}

class Rehearsal {
 public:
  // `frame_s`: of each frame; 0: tick by tick [s]. `scene`: of the hand at the device.
  explicit Rehearsal(const InjectedFault& injected_fault = {}, FalconOptions options = {}, double frame_s = 0.0,
                     const Scene& scene = rehearsal_scene())
      : frame_s_(frame_s) {
    command_.settings = rehearsal_settings();
    command_.restart_state = state_at_start(free_place);
    auto input = std::make_unique<VirtualFalconInput>(std::move(options), injected_fault, scene,
                                                      VirtualFalconInput::Clock::stepped);
    input_ = input.get();
    servo_ = std::make_unique<Servo>(std::move(input), command_);
    input_->move_to(free_place, 0.0);
  }

  void run(double seconds) {
    for (double t = 0.0; t < seconds - 0.5 * step_s(); t += step_s()) step();
  }
  void step() {
    ++command_.heartbeats;
    servo_->send(command_);
    if (frame_s_ == 0.0) return servo_->step();
    pass(frame_s_);
    servo_->step_to(now_ns_);
  }
  // Time of the frames' clock, in which nobody does anything.
  void pass(double seconds) { now_ns_ += std::llround(seconds * 1e9); }
  std::int64_t now_ns() const { return now_ns_; }
  // Until it is so; false: it was not within `seconds`.
  bool run_until(double seconds, const std::function<bool()>& is_so) {
    for (double t = 0.0; t < seconds; t += step_s()) {
      step();
      if (is_so()) return true;
    }
    return false;
  }
  bool run_until_state(FalconState state, double seconds = 30.0) {
    return run_until(seconds, [&] { return falcon().state == state; });
  }
  // Through all the steps, with the hand outside the wall.
  void turn_on() {
    ASSERT_TRUE(run_until_state(FalconState::idle));
    input_->move_to(free_place, 0.5);
    run(2.0);
    ++command_.acknowledgements;
    ++command_.arms_asked;
    ASSERT_TRUE(run_until(3.0, [&] { return motors().state == SafetyState::on; }))
        << entry_of(motors().obstacle).sentence << entry_of(motors().reason).title;
  }
  void use(StrategyId active) {
    command_.settings.active = active;
    ++command_.settings_generation;
  }

  VirtualFalconInput& input() { return *input_; }
  ServoCommand& command() { return command_; }
  Servo& servo() { return *servo_; }
  const FalconReport& falcon() { return input_->report(); }
  const ServoReport& report() { return servo_->newest(); }
  const MotorReport& motors() { return report().motors; }
  // Where the arm really is, in the scene.
  Vector<2> tip() const {
    return FalconPlane(FalconCalibration{}, Vector<2>(0.0)).in_scene(input_->link().arm().position());
  }

  static constexpr Vector<2> free_place{-0.02, 0.02};

 private:
  double step_s() const { return frame_s_ > 0.0 ? frame_s_ : 0.001; }

  double frame_s_;
  std::int64_t now_ns_ = 0;
  ServoCommand command_;
  VirtualFalconInput* input_ = nullptr;
  std::unique_ptr<Servo> servo_;
};

}  // namespace ghostforce
