#include "device/input/circle_input.h"

#include "core/goal_path.h"
#include "core/tick.h"

namespace ghostforce {
void CircleInput::restart(const Vector<2>& goal) noexcept {
  circle_ = circles_.latest();
  start_ = goal;
}

Vector<2> CircleInput::goal(std::int64_t tick, double rate) noexcept {
  const double time_s = time_of(tick, rate);
  const Vector<2> on_circle = position_on(circle_, time_s - circle_begins_s);
  if (time_s >= circle_begins_s) return on_circle;
  // Towards where the circle would be by now: at its beginning the goal has the circle's place and speed.
  const double share = minimum_jerk(time_s / circle_begins_s);
  return start_ + share * (on_circle - start_);
}

}  // namespace ghostforce
