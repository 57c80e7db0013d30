// The hand as a mouse: the window says where the pointer drags the goal to, once per frame; the servo, which is some
// sixteen times faster, moves the goal there along a straight line, so that it never steps. SI units.
//
// move_to() and ignored_moves() belong to the UI thread, everything else to the servo thread. Neither waits, allocates
// or throws.
#pragma once

#include <cstdint>

#include "core/latest_value.h"
#include "device/input/input.h"

namespace ghostforce {

class MouseInput final : public Input, public PointerTarget {
 public:
  // A window that stalled does not make the goal crawl for longer than this [s].
  static constexpr double slowest_move_s = 0.1;

  // Goals are limited to the range of positions in a scene. A duration shorter than a tick counts as one tick. A
  // restart forgets moves that the servo has not begun.
  void move_to(const Vector<2>& goal, double duration_s) noexcept override;
  std::uint64_t ignored_moves() const noexcept override { return ignored_moves_; }

  void restart(const Vector<2>& goal) noexcept override;
  Vector<2> goal(std::int64_t tick, double rate) noexcept override;

 private:
  struct Move {
    Vector<2> to{0.0};        // [m]
    double duration_s = 0.0;  // model time
  };

  std::uint64_t ignored_moves_ = 0;  // UI thread's
  LatestValue<Move> moves_{Move{}};

  // Servo thread's: the line from `from_` to `to_`, of which `ticks_gone_` of `ticks_` are behind us.
  Vector<2> from_{0.0};
  Vector<2> to_{0.0};
  std::int64_t ticks_ = 0;
  std::int64_t ticks_gone_ = 0;

  Vector<2> position() const noexcept;
};

}  // namespace ghostforce
