// The hand as a circle: from where the run starts the goal goes to the circle, as a hand would move, and then round it
// at constant speed. SI units.
//
// go_round() belongs to the UI thread, everything else to the servo thread. Neither waits, allocates or throws.
#pragma once

#include <cstdint>

#include "core/latest_value.h"
#include "core/loop_energy.h"
#include "device/input/input.h"

namespace ghostforce {

class CircleInput final : public Input {
 public:
  explicit CircleInput(const Circle& circle) noexcept : circles_(circle), circle_(circle) {}

  // Another circle, from the next restart on.
  void go_round(const Circle& circle) noexcept { circles_.publish(circle); }

  void restart(const Vector<2>& goal) noexcept override;
  Vector<2> goal(std::int64_t tick, double rate) noexcept override;

 private:
  LatestValue<Circle> circles_;

  // Servo thread's.
  Circle circle_;
  Vector<2> start_{0.0};
};

}  // namespace ghostforce
