// A simulated Haply 2DIY in a simulated hand, under a servo that is stepped by hand: from a board that nobody has set
// up to motors that push into a slanted wall. For tests. The options say how the driver takes the device and how it is.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "device/haply/haply_input.h"
#include "device/servo/servo.h"
#include "tests/device/haply/watched_port.h"
#include "tests/device/servo/motor_settings.h"

namespace ghostforce {

// A wall of 45° through the middle, free on the upper left of the scene.
inline Settings haply_settings(StrategyId active = StrategyId::naive) {
  Settings settings = motor_settings(active);
  settings.wall_normal_angle = 0.75 * std::acos(-1.0);
  return settings;
}

// Bytes that are right for this variant on this board.
inline HaplyCalibration right_calibration(std::string_view variant, HaplyBoard::Kind kind) {
  HaplyCalibration calibration = find_haply_variant(variant)->calibration;
  for (HaplyArm& arm : calibration.arms) {
    if (kind == HaplyBoard::Kind::m0) arm.counts_per_turn *= 2.0;
    arm.is_motor_reversed = kind == HaplyBoard::Kind::dev_kit && arm.motor_port == 1;
  }
  return calibration;
}

inline InjectedHaplyFault haply_fault_named(std::string_view name) {
  InjectedHaplyFault wrong;
  find_injected_haply_fault(name)->add(wrong);
  return wrong;
}

class HeldHaply {
 public:
  struct Options {
    HaplyBench::Options device{};
    HaplyCalibration calibration = usual_haply_variant().calibration;
    Settings settings = haply_settings();
    std::size_t motor = 1;  // whose line lies nearly across that wall
    std::shared_ptr<StopDebts> debts{};
  };

  static constexpr Vector<2> free_place{-0.015, 0.015};
  static constexpr Vector<2> deep_place{0.011, -0.011};

  HeldHaply() : HeldHaply(Options()) {}
  explicit HeldHaply(const Options& options) : calibration_(options.calibration) {
    stiffness_ = options.device.hand.stiffness;
    auto owned = std::make_unique<WatchedPort>(
        VirtualPort::Options{.clock = VirtualPort::Clock::stepped, .device = options.device});
    port_ = owned.get();
    HaplyOptions haply;
    haply.usual = options.calibration;
    haply.is_virtual = true;
    haply.debts = options.debts;
    auto input = std::make_unique<HaplyInput>(std::move(owned), haply, Vector<2>(0.0));
    input_ = input.get();
    input_->choose_motor(options.motor);
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

  // Of the hand's goal, in the scene.
  void lead(const Vector<2>& place, double seconds) {
    HaplyHandPlan plan = haply_hand_at(plane().in_workspace(place), seconds);
    plan.stiffness = stiffness_;
    board().lead_hand(plan);
  }
  void hold_with(double stiffness) { stiffness_ = stiffness; }

  // A person puts the arms where they count from, and says so.
  bool set_zero_pose() {
    board().hold_zero_pose(true);
    const auto may_confirm = [&] {
      return haply().state == HaplyState::zero_pose || haply().state == HaplyState::idle;
    };
    if (!run_until(10.0, may_confirm)) return false;
    if (!run_until(5.0, [&] { return board().bench().hand().is_in_zero_pose(); })) return false;
    run(0.5);
    const std::uint64_t set_ups = truth().set_ups;
    input_->confirm_zero_pose();
    const bool is_set =
        run_until(1.0, [&] { return truth().set_ups > set_ups && haply().zero_pose == ZeroPose::confirmed; });
    board().hold_zero_pose(false);
    run(0.5);
    return is_set;
  }
  // Moves both arms, and rests outside the wall.
  bool move_a_little() {
    lead(free_place + Vector<2>(-0.01, -0.01), 0.3);
    run(0.8);
    lead(free_place, 0.3);
    run(1.2);
    return motors().is_ready;
  }
  bool get_ready() { return set_zero_pose() && move_a_little(); }

  void ask_to_arm() {
    ++command_.acknowledgements;
    ++command_.arms_asked;
  }
  void disarm() { ++command_.offs_asked; }
  bool arm() {
    ask_to_arm();
    return run_until(6.0, [&] { return motors().state == SafetyState::on; });
  }
  // On, and into the wall.
  bool press(const Vector<2>& place = deep_place) {
    if (!get_ready() || !arm()) return false;
    lead(place, 0.5);
    run(1.5);
    // Now and then the force dips, to ask whether the encoders count.
    return run_until(0.2, [&] { return force() > 1.0; }) && motors().state == SafetyState::on;
  }
  void use(StrategyId active) {
    command_.settings.active = active;
    ++command_.settings_generation;
  }

  void inject(std::string_view name) { board().inject(haply_fault_named(name)); }
  void mend() { board().inject({}); }

  WatchedPort& port() { return *port_; }
  VirtualPort& board() { return port_->board(); }
  HaplyInput& input() { return *input_; }
  Servo& servo() { return *servo_; }
  void end_servo() { servo_.reset(); }
  ServoCommand& command() { return command_; }
  const MotorReport& motors() { return servo_->newest().motors; }
  const HaplyReport& haply() { return input_->report(); }
  std::string_view reason() { return entry_of(motors().reason).name; }

  // How things really are.
  HaplyTruth truth() { return board().truth(); }
  bool pushes() { return truth().duties != std::array{0.0, 0.0}; }
  double force() { return glm::length(truth().force); }
  Vector<2> tip() { return plane().in_scene(truth().handle); }
  // How far what is said of the handle is from the truth [m].
  double misplaced() { return glm::length(motors().handle - tip()); }
  HaplyPlane plane() const { return {calibration_, Vector<2>(0.0)}; }

 private:
  HaplyCalibration calibration_;
  double stiffness_ = 100.0;
  WatchedPort* port_ = nullptr;
  HaplyInput* input_ = nullptr;
  ServoCommand command_;
  std::unique_ptr<Servo> servo_;
};

// For how long a board pushes, and how far a handle goes, from when it was made until its owner goes.
class PushWatch {
 public:
  explicit PushWatch(HeldHaply& haply)
      : haply_(haply), began_ns_(haply.port().now_ns()), start_(haply.truth().handle), last_ns_(began_ns_) {
    last_pushing_ns_ = haply.pushes() ? began_ns_ : 0;
    haply.port().on_step = [this] { look(); };
  }
  ~PushWatch() { haply_.port().on_step = nullptr; }
  PushWatch(const PushWatch&) = delete;
  PushWatch& operator=(const PushWatch&) = delete;

  // From the beginning until nothing pushed any more [ms]; 0 if nothing ever did.
  double ms_pushing() const {
    return last_pushing_ns_ == 0 ? 0.0 : 1e-6 * static_cast<double>(last_pushing_ns_ - began_ns_);
  }
  double greatest_force() const { return greatest_force_; }
  double farthest() const { return farthest_; }
  double impulse() const { return impulse_; }  // [N·s]

 private:
  void look() {
    const HaplyTruth truth = haply_.truth();
    const std::int64_t now_ns = haply_.port().now_ns();
    if (truth.duties != std::array{0.0, 0.0}) last_pushing_ns_ = now_ns;
    const double force = glm::length(truth.force);
    greatest_force_ = std::max(greatest_force_, force);
    impulse_ += 1e-9 * static_cast<double>(now_ns - std::exchange(last_ns_, now_ns)) * force;
    farthest_ = std::max(farthest_, glm::length(truth.handle - start_));
  }

  HeldHaply& haply_;
  std::int64_t began_ns_;
  Vector<2> start_;
  std::int64_t last_pushing_ns_ = 0;
  std::int64_t last_ns_;
  double greatest_force_ = 0.0;
  double farthest_ = 0.0;
  double impulse_ = 0.0;
};

}  // namespace ghostforce
