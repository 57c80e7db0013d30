#include "device/virtual_haply/measured_haply_person.h"

#include <cstdio>
#include <numbers>

namespace ghostforce {
namespace {

constexpr double hand_way_s = 0.8;
constexpr double firm_grip = 800.0;  // of who turns a link to where it is to be [N/m]
constexpr double firm_damping = 10.0;

// A weight on its thread: a spring that is soft and very long pulls as evenly [N/m].
constexpr double thread_stiffness = 1.0;
constexpr double thread_damping = 0.1;

}  // namespace

void MeasuredHaplyPerson::lead(const Vector<2>& place, double stiffness, double damping) {
  const double all = stiffness + thread_stiffness;
  const Vector<2> pulled{0.0, load_ / all};
  // From where the handle is, whatever another hand's goal was.
  HaplyHandPlan plan = haply_hand_at(port_.handle() + pulled);
  if (stiffness > 0.0) plan.add({.time = hand_way_s, .goal = place + pulled});
  plan.stiffness = stiffness == 0.0 && load_ == 0.0 ? 0.0 : all;
  plan.damping = damping;
  port_.lead_hand(plan);
}

std::string MeasuredHaplyPerson::act(const HaplyAction& action) {
  if (action.kind != HaplyAction::Kind::read_on && action.kind != HaplyAction::Kind::say_yes_or_no) {
    port_.hold_zero_pose(action.kind == HaplyAction::Kind::hold_zero_pose);
  }
  switch (action.kind) {
    case HaplyAction::Kind::read_on:
    case HaplyAction::Kind::hold_zero_pose:
      return {};
    case HaplyAction::Kind::turn_arm: {
      constexpr double halfway = 0.25 * std::numbers::pi;
      Vector<2> angles{std::numbers::pi - halfway, halfway};
      angles[static_cast<glm::length_t>(action.arm)] = action.angle + habits_.angle_off;
      const auto place = port_.bench().variant().geometry.place(angles);
      if (place) lead(place->handle, firm_grip, firm_damping);
      return {};
    }
    case HaplyAction::Kind::hold:
      lead(action.place, habits_.grip, habits_.damping);
      return {};
    case HaplyAction::Kind::let_go:
      lead(action.place, 0.0, thread_damping);
      return {};
    case HaplyAction::Kind::hang_weight:
      load_ = action.weight;
      lead(action.place, habits_.grip, habits_.damping);
      return {};
    case HaplyAction::Kind::press:
      lead(action.place - Vector<2>{0.0, habits_.pressing / habits_.grip}, habits_.grip, habits_.damping);
      return {};
    case HaplyAction::Kind::say_weight: {
      char text[32];
      std::snprintf(text, sizeof text, "%.10g", habits_.weight);
      return text;
    }
    case HaplyAction::Kind::say_yes_or_no:
      return "y";
  }
  return {};
}

}  // namespace ghostforce
