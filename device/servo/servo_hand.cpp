// How the servo measures the hand, and lets the belief about it follow.
#include <optional>
#include <utility>

#include "core/belief.h"
#include "device/servo/servo.h"

namespace ghostforce {

// The tones from this tick to the next, in the plane [N].
Vector<2> Servo::sound_tones(bool are_allowed, bool in_contact) noexcept {
  // Along a line that turns, they would measure the turn as well.
  const bool can_measure = wants_tones_ && !handle_.motor_angle;
  const double tone = measurement_.sound(can_measure && are_allowed, in_contact, tone_force_);
  return tone * motor_axis_;
}

// By what the newest tick has made of it, which the snapshot has. True: there is a new estimate.
bool Servo::measure_hand() noexcept {
  const bool measures = (wants_tones_ && !handle_.motor_angle) || measurement_.is_sounding();
  if (!measures) {
    if (report_.hand.is_measuring || report_.hand.tone_gain > 0.0) end_measuring();
    return false;
  }
  const bool is_real = safety_.is_armed();
  const HandSource source{settings_.actuated_angle, is_real ? std::nullopt : std::optional(settings_.active)};
  if (std::exchange(hand_source_, source) != source) measurement_.interrupt();
  const StrategySnapshot<2>& active = report_.snapshot.strategies[index_of(settings_.active)];
  // In the scene, where distances and forces of a device are both other than at its handle, a stiffness is the same.
  const double at_handle = is_real ? device_->force_at_handle() : 1.0;
  const Vector<2> force = is_real ? report_.motors.sent / at_handle : active.force + tone_;
  const Vector<2> place = is_real ? active.device : measured_position(limited_settings_, active.device);
  const bool has_estimate = measurement_.add({.position = glm::dot(motor_axis_, place),
                                              .force = glm::dot(motor_axis_, force),
                                              .tone = glm::dot(motor_axis_, tone_),
                                              .in_contact = active.in_contact,
                                              .is_at_limit = is_real && report_.motors.is_saturated},
                                             report_.snapshot.time_s);
  report_.hand = measurement_.reading();
  report_.hand.believed_k_u = believed_user_stiffness(settings_.stiffnesses);
  return has_estimate;
}

void Servo::end_measuring() noexcept {
  measurement_.interrupt(HandUnknown::no_tones);
  report_.hand = {.estimate = measurement_.reading().estimate,
                  .believed_k_u = believed_user_stiffness(settings_.stiffnesses)};
}

// From the belief as it is, however it was chosen.
void Servo::begin_following() noexcept {
  Stiffnesses& stiffnesses = settings_.stiffnesses;
  stiffnesses.believed_k_u = believed_user_stiffness(stiffnesses);
  stiffnesses.chosen_tracking_ratio.reset();
  follower_.emplace(*stiffnesses.believed_k_u);
  update_coefficients();
}

// Without a cross-fade: it would hold back the whole force for as long as the belief moves.
void Servo::follow_hand() noexcept {
  if (!follower_) return;
  const double believed = follower_->update(report_.hand.estimate, limited_settings_.stiffnesses.k_r,
                                            least_regret_belief(limited_settings_));
  if (settings_.stiffnesses.believed_k_u == believed) return;
  settings_.stiffnesses.believed_k_u = report_.hand.believed_k_u = believed;
  update_coefficients(Change::steps);
}

}  // namespace ghostforce
