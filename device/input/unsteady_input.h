// UnsteadyInput: another input, with the hand of a scene between it and the devices. That hand is not still, and grips
// harder and softer; the goal of the other input is where it means to be. Threads as for the other one; SI units.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "core/hand_unrest.h"
#include "core/scene.h"
#include "device/input/input.h"

namespace ghostforce {

class UnsteadyInput final : public Input {
 public:
  UnsteadyInput(std::unique_ptr<Input> input, StiffnessPath stiffness, const HandUnrest& unrest)
      : input_(std::move(input)), stiffness_(std::move(stiffness)), unrest_(unrest) {}

  void restart(const Vector<2>& goal) noexcept override {
    if (unrest_.is_still()) return input_->restart(goal);
    start_ = goal;
  }

  Vector<2> goal(std::int64_t tick, double rate) noexcept override {
    // A run may go on from a moment at which the hand was elsewhere than it meant to be.
    if (start_) input_->restart(*start_ - unrest_.at(time_of(tick - 1, rate)));
    start_.reset();
    return unrest_.shaken(input_->goal(tick, rate), time_of(tick, rate));
  }

  std::optional<double> user_stiffness(std::int64_t tick, double rate) noexcept override {
    if (stiffness_.is_empty()) return {};
    return stiffness_at(stiffness_, time_of(tick, rate));
  }

  HapticDevice* haptic_device() noexcept override { return input_->haptic_device(); }

 private:
  std::unique_ptr<Input> input_;
  StiffnessPath stiffness_;
  UnrestMotion unrest_;
  std::optional<Vector<2>> start_;  // of a run of a restless hand that has not ticked yet
};

// The input with that scene's hand: as it is where the hand is steady. A hand at a real device, or a recorded one,
// `has_own_unrest`, and only as much as the scene says of its stiffness is added to it.
inline std::unique_ptr<Input> in_hand_of(const Scene& scene, std::unique_ptr<Input> input, bool has_own_unrest) {
  const HandUnrest unrest = has_own_unrest ? HandUnrest{} : scene.unrest;
  if (unrest.is_still() && scene.stiffness_path.is_empty()) return input;
  return std::make_unique<UnsteadyInput>(std::move(input), scene.stiffness_path, unrest);
}

}  // namespace ghostforce
