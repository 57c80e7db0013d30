#include "device/virtual_falcon/hand.h"

#include <algorithm>

namespace ghostforce {

HandPlan hand_at(const Vector<3>& goal, double time) noexcept {
  HandPlan plan;
  plan.waypoints[0] = {.time = time, .goal = goal};
  return plan;
}

HandPlan homing_hand() noexcept {
  // Beyond either stop, so that it is felt; firm enough for a handle that something else pulls at.
  constexpr Vector<3> out{0.0, 0.0, 0.18};
  constexpr Vector<3> in{0.0, 0.0, 0.06};
  HandPlan plan = hand_at(out, 0.5);
  plan.add({.time = 0.7, .goal = out});
  plan.add({.time = 1.5, .goal = in});
  plan.add({.time = 1.9, .goal = in});
  plan.add({.time = 2.4, .goal = HandPlan::centre});
  plan.stiffness = 200.0;
  return plan;
}

SimulatedHand::SimulatedHand(const HandPlan& plan, std::int64_t now_ns) noexcept
    : plans_(plan), course_{plan, now_ns, plan.waypoints[0].goal}, goal_(plan.waypoints[0].goal) {}

void SimulatedHand::advance(std::int64_t now_ns, bool device_asks_for_homing) noexcept {
  if (plans_.has_news()) course_ = {plans_.latest(), now_ns, goal_};
  if (homing_ && homing_->is_over(now_ns)) {
    homing_.reset();
    course_ = {course_.plan, now_ns, goal_};
  }
  if (!homing_ && device_asks_for_homing && course_.plan.homes_when_asked) {
    homing_ = Course{homing_hand(), now_ns, goal_};
  }
  (homing_ ? *homing_ : course_).look_up(now_ns, goal_, buttons_);
}

double SimulatedHand::stiffness() const noexcept {
  return homing_ ? homing_->plan.stiffness : stiffness_.value_or(course_.plan.stiffness);
}

void SimulatedHand::Course::look_up(std::int64_t now_ns, Vector<3>& goal, std::uint8_t& buttons) const noexcept {
  const double time = static_cast<double>(now_ns - start_ns) * 1e-9;
  HandPlan::Waypoint from{.goal = start, .buttons = buttons};
  for (std::size_t i = 0; i < std::min(plan.count, plan.waypoints.size()); ++i) {
    const HandPlan::Waypoint& to = plan.waypoints[i];
    if (time < to.time) {
      const double share = std::clamp((time - from.time) / (to.time - from.time), 0.0, 1.0);
      goal = from.goal + share * (to.goal - from.goal);
      buttons = from.buttons;
      return;
    }
    from = to;
  }
  goal = from.goal;
  buttons = from.buttons;
}

bool SimulatedHand::Course::is_over(std::int64_t now_ns) const noexcept {
  return plan.count == 0 || static_cast<double>(now_ns - start_ns) * 1e-9 >= plan.waypoints[plan.count - 1].time;
}

}  // namespace ghostforce
