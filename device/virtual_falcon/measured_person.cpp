#include "device/virtual_falcon/measured_person.h"

#include <cmath>
#include <cstdio>

#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

constexpr double way_s = 0.8;
constexpr std::uint8_t held_button = ReplyFrame::button_centre;

std::string in_words(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

}  // namespace

void MeasuredPerson::lead(const Vector<3>& place, double stiffness, std::uint8_t buttons) {
  place_ = place;
  HandPlan plan = hand_at(place, way_s);
  plan.waypoints[0].buttons = buttons;
  if (buttons != 0) {
    // A plan's buttons are pressed at its waypoints: at once, wherever the hand is on its way.
    plan.waypoints[0] = {.time = 0.0, .goal = link_.hand().goal(), .buttons = buttons};
    plan.add({.time = way_s, .goal = place, .buttons = buttons});
  }
  plan.stiffness = stiffness;
  plan.load = load_;
  link_.lead_hand(plan);
}

std::string MeasuredPerson::act(const OperatorAction& action) {
  switch (action.kind) {
    case OperatorAction::Kind::read_on:
      return {};
    case OperatorAction::Kind::go_to:
    case OperatorAction::Kind::take_again:
      marks_[0] = link_.arm().position();
      lead(action.place, habits_.grip, 0);
      return {};
    case OperatorAction::Kind::push_in:
      lead({0.0, 0.0, 0.06}, 2.0 * habits_.grip, 0);
      return {};
    case OperatorAction::Kind::hold_button:
      lead(action.place, habits_.grip, held_button);
      return {};
    case OperatorAction::Kind::loosen:
      lead(place_, habits_.fingertip, held_button);
      return {};
    case OperatorAction::Kind::hang_weight:
      load_ = action.weight;
      lead(action.place, habits_.grip, 0);
      return {};
    case OperatorAction::Kind::press: {
      HandPlan plan = hand_at(place_, 0.0);
      plan.waypoints[0].buttons = action.buttons;
      // Longer than a link may leave out that nobody has looked at.
      plan.add({.time = 2.5, .goal = place_});
      plan.stiffness = habits_.grip;
      plan.load = load_;
      link_.lead_hand(plan);
      return {};
    }
    case OperatorAction::Kind::say_distance: {
      marks_[1] = link_.arm().position();
      const double distance_mm = 1e3 * glm::distance(marks_[0], marks_[1]);
      return in_words(habits_.ruler_step * std::round(distance_mm / habits_.ruler_step));
    }
    case OperatorAction::Kind::say_weight:
      return in_words(habits_.weight);
    case OperatorAction::Kind::say_light: {
      const std::uint8_t lights = link_.device().lights();
      if (lights == CommandFrame::red) return "red";
      if (lights == CommandFrame::green) return "green";
      return lights == CommandFrame::blue ? "blue" : "other";
    }
    case OperatorAction::Kind::say_yes_or_no:
      return "y";
  }
  return {};
}

}  // namespace ghostforce
