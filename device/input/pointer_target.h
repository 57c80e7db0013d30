// PointerTarget: an input whose goal the pointer of the window moves. UI thread; nothing here waits, allocates or
// throws.
#pragma once

#include <cstdint>

#include "core/conventions.h"

namespace ghostforce {

class PointerTarget {
 public:
  PointerTarget() = default;
  PointerTarget(const PointerTarget&) = delete;
  PointerTarget& operator=(const PointerTarget&) = delete;
  virtual ~PointerTarget() = default;

  // Moves the goal to `goal` [m] within `duration_s` of model time, which is the time until the next call: frame
  // interval × speed. A goal that is not finite is ignored and counted.
  virtual void move_to(const Vector<2>& goal, double duration_s) noexcept = 0;

  virtual std::uint64_t ignored_moves() const noexcept = 0;

  // The stiffness of the hand that the pointer guides, for a hand that is not part of the model [N/m].
  virtual void set_user_stiffness(double /*k_u*/) noexcept {}
};

}  // namespace ghostforce
