// FalconChip: a whole Falcon at the far end of an emulated cable: its chip and processor, an arm, and a hand that homes
// it when it is asked to. The virtual Falcon's parts, driven by the emulated device's clock. Any thread; lead_hand()
// one other.
#pragma once

#include <time.h>

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <utility>

#include "device/virtual_falcon/arm.h"
#include "device/virtual_falcon/falcon_dsp.h"
#include "device/virtual_falcon/hand.h"
#include "tests/emulation/emulated_chip.h"

namespace ghostforce {

class FalconChip final : public EmulatedChip {
 public:
  // What motors and lights have been told.
  struct Told {
    MotorNumbers motors{};             // driven with now [counts]
    std::int64_t last_force_ns = 0;    // when they were last driven with anything but 0; 0: never
    std::int64_t longest_hold_ns = 0;  // that a force stood without a new command, since watch()
    std::uint64_t frames = 0;          // since the beginning
    std::uint64_t force_frames = 0;    // those of them that asked for a force
    std::uint64_t silent_frames = 0;   // the newest ones in a row that asked for no force and no light
    bool is_homed = false;
  };

  explicit FalconChip(const FalconDsp::Options& options = {}) : FalconChip(options, now_ns()) {}

  void lead_hand(HandPlan plan) noexcept {
    plan.homes_when_asked = true;
    hand_.follow(plan);
  }

  // Of the serial line and what is behind it; see EmulatedUsbDevice::inject() for the cable.
  void inject(const InjectedFault& wrong) {
    const std::lock_guard lock(mutex_);
    live_until(now_ns());
    dsp_.inject(wrong);
    note();
  }

  void watch() {
    const std::lock_guard lock(mutex_);
    told_.longest_hold_ns = 0;
  }

  // What is under way arrives first.
  Told told() {
    const std::lock_guard lock(mutex_);
    const std::int64_t now = now_ns();
    live_until(now);
    dsp_.advance(now);
    note();
    return told_;
  }

  void power_up(std::int64_t now_ns) override {
    const std::lock_guard lock(mutex_);
    live_until(now_ns);
    dsp_.power_up_chip(now_ns);
    note();
  }

  void control(const VendorRequest& request, std::int64_t now_ns) override {
    const std::lock_guard lock(mutex_);
    live_until(now_ns);
    dsp_.control(request, now_ns);
    note();
  }

  std::size_t room() const override {
    const std::lock_guard lock(mutex_);
    return dsp_.room();
  }

  void receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns) override {
    const std::lock_guard lock(mutex_);
    live_until(now_ns);
    dsp_.receive(bytes, now_ns);
    note();
  }

  std::size_t take_packet(std::span<std::uint8_t, packet_size> into, std::int64_t now_ns) override {
    const std::lock_guard lock(mutex_);
    live_until(now_ns);
    const std::size_t size = dsp_.take_packet(into, now_ns);
    note();
    return size;
  }

  std::int64_t next_due_ns() const override {
    const std::lock_guard lock(mutex_);
    return dsp_.next_due_ns();
  }

  Vector<3> position() const {
    const std::lock_guard lock(mutex_);
    return arm_.position();
  }

  std::array<std::int16_t, 3> motors() const {
    const std::lock_guard lock(mutex_);
    return dsp_.motors();
  }

 private:
  static constexpr std::int64_t step_ns = 100'000;
  static constexpr std::int64_t longest_gap_ns = 100'000'000;  // while nobody looks, nothing happens

  static std::int64_t now_ns() noexcept {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
  }

  static HandPlan plan() noexcept {
    HandPlan plan;
    plan.homes_when_asked = true;
    return plan;
  }

  FalconChip(const FalconDsp::Options& options, std::int64_t now_ns)
      : lived_ns_(now_ns), dsp_(options, now_ns), arm_({}), hand_(plan(), now_ns) {
    dsp_.set_encoders(arm_.encoders());
  }

  void live_until(std::int64_t now_ns) noexcept {
    lived_ns_ = std::max(lived_ns_, now_ns - longest_gap_ns);
    for (; lived_ns_ + step_ns <= now_ns; lived_ns_ += step_ns) {
      dsp_.advance(lived_ns_ + step_ns);
      note();
      if (told_.motors != MotorNumbers{}) {
        told_.last_force_ns = lived_ns_ + step_ns;
        told_.longest_hold_ns = std::max(told_.longest_hold_ns, told_.last_force_ns - commanded_ns_);
      }
      hand_.advance(lived_ns_ + step_ns, dsp_.wants_homing());
      arm_.step(static_cast<double>(step_ns) * 1e-9, dsp_.motors(), hand_.goal(), hand_.stiffness());
      dsp_.set_encoders(arm_.encoders());
    }
  }

  void note() noexcept {
    told_.motors = dsp_.motors();
    told_.is_homed = dsp_.homed() == ReplyFrame::homed;
    const std::uint64_t news = dsp_.frames() - std::exchange(told_.frames, dsp_.frames());
    if (news == 0) return;
    commanded_ns_ = lived_ns_;
    const bool is_silent = dsp_.last_command().motors == MotorNumbers{} && dsp_.lights() == 0;
    if (dsp_.last_command().motors != MotorNumbers{}) told_.force_frames += news;
    told_.silent_frames = is_silent ? told_.silent_frames + news : 0;
  }

  mutable std::mutex mutex_;
  std::int64_t lived_ns_;
  FalconDsp dsp_;
  SimulatedArm arm_;
  SimulatedHand hand_;
  Told told_;
  std::int64_t commanded_ns_ = 0;  // when the newest command came, to a step
};

}  // namespace ghostforce
