// UnsteadyInput: another input, with the hand of a scene between it and the devices. That hand is not still, and grips
// harder and softer; the goal of the other input is where it means to be. Threads as for the other one; SI units.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "core/scene.h"
#include "core/tremor_and_drift.h"
#include "device/input/input.h"

namespace ghostforce {

class UnsteadyInput final : public Input {
 public:
  UnsteadyInput(std::unique_ptr<Input> input, StiffnessPath stiffness, const TremorAndDrift& tremor_and_drift)
      : input_(std::move(input)), stiffness_(std::move(stiffness)), tremor_and_drift_(tremor_and_drift) {}

  void restart(const Vector<2>& goal) noexcept override {
    if (tremor_and_drift_.is_still()) return input_->restart(goal);
    start_ = goal;
  }

  Vector<2> goal(std::int64_t tick, double rate) noexcept override {
    // A run may go on from a moment at which the hand was elsewhere than it meant to be.
    if (start_) input_->restart(*start_ - tremor_and_drift_.at(time_of(tick - 1, rate)));
    start_.reset();
    return tremor_and_drift_.shaken(input_->goal(tick, rate), time_of(tick, rate));
  }

  std::optional<double> user_stiffness(std::int64_t tick, double rate) noexcept override {
    if (stiffness_.is_empty()) return {};
    return stiffness_at(stiffness_, time_of(tick, rate));
  }

  HapticDevice* haptic_device() noexcept override { return input_->haptic_device(); }

 private:
  std::unique_ptr<Input> input_;
  StiffnessPath stiffness_;
  TremorAndDriftMotion tremor_and_drift_;
  std::optional<Vector<2>> start_;  // of a run of a restless hand that has not ticked yet
};

// The input with that scene's hand: as it is where the hand is steady. A hand at a real device, or a recorded one,
// `has_own_tremor`, and only as much as the scene says of its stiffness is added to it.
inline std::unique_ptr<Input> in_hand_of(const Scene& scene, std::unique_ptr<Input> input, bool has_own_tremor) {
  const TremorAndDrift tremor_and_drift = has_own_tremor ? TremorAndDrift{} : scene.tremor_and_drift;
  if (tremor_and_drift.is_still() && scene.stiffness_path.is_empty()) return input;
  return std::make_unique<UnsteadyInput>(std::move(input), scene.stiffness_path, tremor_and_drift);
}

}  // namespace ghostforce
