#include "device/virtual_haply/haply_hand.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

constexpr double seconds_of(std::int64_t ns) noexcept {
  return static_cast<double>(ns) * 1e-9;
}

}  // namespace

HaplyHandPlan haply_hand_at(const Vector<2>& goal, double time) noexcept {
  HaplyHandPlan plan;
  plan.add({.time = time, .goal = goal});
  return plan;
}

VirtualHaplyHand::VirtualHaplyHand(const HaplyHandPlan& plan, const Vector<2>& middle, std::int64_t now_ns) noexcept
    : plans_(plan), plan_(plan), middle_(middle), plan_start_ns_(now_ns), plan_start_(middle), last_ns_(now_ns) {
  pull_ = {.goal = middle, .stiffness = plan.stiffness, .damping = plan.damping};
}

void VirtualHaplyHand::advance(std::int64_t now_ns, const HaplyArms& arms, const Vector<2>& zero_pose) noexcept {
  const bool is_to_hold = is_to_hold_;
  if (is_to_hold && !pull_.holds_pose) pull_.pose = arms.angles();
  if (!is_to_hold && pull_.holds_pose) {
    released_ns_ = now_ns;
    released_at_ = arms.handle();
    plan_start_ns_ = now_ns;
    plan_start_ = released_at_;
  }
  pull_.holds_pose = is_to_hold;
  if (plans_.has_news()) {
    plan_ = plans_.latest();
    plan_start_ns_ = now_ns;
    plan_start_ = pull_.goal;
    HaplyHandPlan::Waypoint& first = plan_.waypoints[0];
    first.time = std::max(first.time, glm::distance(plan_start_, first.goal) / plan_.greatest_speed);
  }
  const double turn = turning_speed * seconds_of(now_ns - last_ns_);
  last_ns_ = now_ns;
  for (glm::length_t i = 0; i < 2; ++i) pull_.pose[i] += std::clamp(zero_pose[i] - pull_.pose[i], -turn, turn);
  const Vector<2> left = arms.angles() - zero_pose;
  is_in_zero_pose_ = is_to_hold && std::abs(left.x) + std::abs(left.y) < 0.1 * radians_per_degree;

  pull_.goal = planned_goal(now_ns);
  pull_.stiffness = plan_.stiffness;
  pull_.damping = plan_.damping;
  if (is_to_hold) {
    pull_.goal = arms.handle();
  } else if (released_ns_ != 0) {
    const double share = std::min(1.0, seconds_of(now_ns - released_ns_) / return_s);
    pull_.goal = released_at_ + share * (pull_.goal - released_at_);
    if (share == 1.0) released_ns_ = 0;
  }
}

Vector<2> VirtualHaplyHand::planned_goal(std::int64_t now_ns) const noexcept {
  if (plan_.count == 0) return middle_;
  const double time = seconds_of(now_ns - plan_start_ns_);
  HaplyHandPlan::Waypoint from{.goal = plan_start_};
  for (std::size_t i = 0; i < std::min(plan_.count, plan_.waypoints.size()); ++i) {
    const HaplyHandPlan::Waypoint& to = plan_.waypoints[i];
    if (time < to.time) {
      const double share = std::clamp((time - from.time) / (to.time - from.time), 0.0, 1.0);
      return from.goal + share * (to.goal - from.goal);
    }
    from = to;
  }
  return from.goal;
}

}  // namespace ghostforce
