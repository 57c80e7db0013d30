// The hand as a circle: from where the run starts the goal goes to the circle, as a hand would move, and then round it
// at constant speed. SI units.
//
// go_round() belongs to the UI thread, everything else to the servo thread. Neither waits, allocates or throws.
#pragma once

#include <cstdint>

#include "core/goal_path.h"
#include "core/latest_value.h"
#include "core/loop_energy.h"
#include "core/tick.h"
#include "device/input/input.h"

namespace ghostforce {

class CircleInput final : public Input {
 public:
  explicit CircleInput(const Circle& circle) noexcept : circles_(circle), circle_(circle) {}

  // Another circle, from the next restart on.
  void go_round(const Circle& circle) noexcept { circles_.publish(circle); }

  void restart(const Vector<2>& goal) noexcept override {
    circle_ = circles_.latest();
    start_ = goal;
  }

  Vector<2> goal(std::int64_t tick, double rate) noexcept override {
    const double time_s = time_of(tick, rate);
    const Vector<2> on_circle = position_on(circle_, time_s - circle_begins_s);
    if (time_s >= circle_begins_s) return on_circle;
    // Towards where the circle would be by now: at its beginning the goal has the circle's place and speed.
    const double share = minimum_jerk(time_s / circle_begins_s);
    return start_ + share * (on_circle - start_);
  }

 private:
  LatestValue<Circle> circles_;

  // Servo thread's.
  Circle circle_;
  Vector<2> start_{0.0};
};

}  // namespace ghostforce
