// A virtual Falcon, homed, in a hand of any kind, under a servo that is stepped by hand: for tests of what the driver
// finds out about motors and encoders. The calibration says how the driver takes the device, `link.arm` how it is.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "core/scene.h"
#include "device/falcon/falcon_input.h"
#include "device/servo/servo.h"
#include "device/virtual_falcon/virtual_link.h"
#include "tests/device/servo/motor_settings.h"

namespace ghostforce {

// A 45° wall through the middle, free on the upper left; motor along x.
inline Settings slanted_wall_settings() {
  Settings settings = motor_settings(StrategyId::naive);
  settings.wall_normal_angle = 0.75 * std::acos(-1.0);
  return settings;
}

class HeldFalcon {
 public:
  struct Options {
    FalconCalibration calibration{};
    SimulatedArm::Options arm{};
    double stiffness = 100.0;  // of the hand [N/m]
    Settings settings = slanted_wall_settings();
  };

  static constexpr Vector<2> free_place{-0.02, 0.02};
  static constexpr Vector<2> deep_place{0.02, -0.02};

  HeldFalcon() : HeldFalcon(Options()) {}
  explicit HeldFalcon(Options options) : stiffness_(options.stiffness) {
    VirtualLink::Options link{.clock = VirtualLink::Clock::stepped, .arm = options.arm};
    link.device.starts_with_firmware = true;
    link.device.starts_homed = true;
    link.hand.stiffness = stiffness_;
    options.calibration.serial = *DeviceSerial::from(VirtualLink::serial_number);
    auto owned = std::make_unique<VirtualLink>(link);
    link_ = owned.get();
    FalconOptions falcon;
    falcon.calibrations = {options.calibration};
    auto input = std::make_unique<FalconInput>(std::move(owned), falcon, Vector<2>(0.0));
    input_ = input.get();
    command_.settings = options.settings;
    command_.restart_state = state_at_start(free_place);
    servo_ = std::make_unique<Servo>(std::move(input), command_);
  }

  void step() {
    ++command_.heartbeats;
    servo_->send(command_);
    servo_->step();
    for (Sample sample; servo_->take_sample(sample);) continue;
  }
  void run(double seconds) {
    for (double t = 0.0; t < seconds - 0.0005; t += 0.001) step();
  }
  bool run_until(double seconds, const std::function<bool()>& is_so) {
    for (double t = 0.0; t < seconds; t += 0.001) {
      step();
      if (is_so()) return true;
    }
    return false;
  }

  // In the scene, where the calibration is the default one's.
  void lead(const Vector<2>& place, double seconds) {
    HandPlan plan = hand_at(FalconPlane(FalconCalibration{}, Vector<2>(0.0)).in_workspace(place), seconds);
    plan.stiffness = stiffness_;
    link_->lead_hand(plan);
  }

  // Until it could be armed, outside the wall.
  bool get_ready() {
    lead({-0.03, 0.0}, 0.3);
    run(0.8);
    lead(free_place, 0.3);
    run(1.0);
    return motors().is_ready;
  }
  void ask_to_arm() {
    ++command_.acknowledgements;
    ++command_.arms_asked;
  }
  void disarm() { ++command_.offs_asked; }
  void use(StrategyId active) {
    command_.settings.active = active;
    ++command_.settings_generation;
  }
  bool arm() {
    ask_to_arm();
    return run_until(5.0, [&] { return motors().state == SafetyState::on; });
  }

  // While so much time passes: the longest time for which a motor was driven without a pause of 50 ms [s].
  double longest_drive(double seconds) {
    double longest = 0.0;
    double began = 0.0;
    double last = -1.0;
    for (double t = 0.0; t < seconds; t += 0.001) {
      step();
      if (link_->motors() == MotorNumbers{}) continue;
      if (t - last > 0.05 || last < 0.0) began = t;
      last = t;
      longest = std::max(longest, last + 0.001 - began);
    }
    return longest;
  }

  void inject(const char* name) {
    InjectedFault wrong;
    find_injected_fault(name)->add(wrong);
    link_->inject(wrong);
  }

  VirtualLink& link() { return *link_; }
  FalconInput& input() { return *input_; }
  ServoCommand& command() { return command_; }
  const MotorReport& motors() { return servo_->newest().motors; }
  Servo& servo() { return *servo_; }

 private:
  double stiffness_;
  VirtualLink* link_ = nullptr;
  FalconInput* input_ = nullptr;
  ServoCommand command_;
  std::unique_ptr<Servo> servo_;
};

}  // namespace ghostforce
