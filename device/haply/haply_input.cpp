#include "device/haply/haply_input.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "core/safety.h"

namespace ghostforce {
namespace {

// A reply that is about to come is waited for this long after a tick is due [ns].
constexpr std::int64_t patience_ns = 1'000'000;

// An older position is none [s].
constexpr double longest_known_s = Safety::longest_exchange_s;

// 0.123 N·m at full duty is a number in the firmware, the same for all motors and supplies: until somebody has measured
// theirs, the true torque may be half as much again. After that, what a weight and a ruler leave.
constexpr double unmeasured_uncertainty = 1.5;
constexpr double measured_uncertainty = 1.1;

// One arm turns so far, and the encoder of the other tells not one step: only by chance is that its true place [rad].
constexpr double frozen_rad = 5.0 * radians_per_degree;

OffReason trouble_of(const HaplyReport& report) noexcept {
  switch (report.state) {
    case HaplyState::idle:
    case HaplyState::active:
      return OffReason::none;
    case HaplyState::opening:
    case HaplyState::zero_pose:
      return OffReason::not_homed;
    case HaplyState::absent:
      return OffReason::unplugged;
    case HaplyState::fault:
      if (report.fault == HaplyFault::unplugged) return OffReason::unplugged;
      return report.fault == HaplyFault::overruled ? OffReason::overruled : OffReason::fault;
  }
  return OffReason::fault;
}

// Torque on each arm per newton along its own motor's line [m].
std::array<double, 2> levers_of(const PantographPose& pose) noexcept {
  return {glm::dot(pose.jacobian[0], line_of_motor(pose, 0)), glm::dot(pose.jacobian[1], line_of_motor(pose, 1))};
}

}  // namespace

HaplyInput::HaplyInput(std::unique_ptr<SerialPort> port, HaplyOptions options, const Vector<2>& view_center)
    : haply_(std::move(port), std::move(options)), view_center_(view_center) {}

Vector<2> HaplyInput::goal(std::int64_t /*tick*/, double rate) noexcept {
  return reading_.is_known ? goal_.next(reading_.position, rate) : goal_.waiting();
}

void HaplyInput::wait_until(std::int64_t deadline_ns) noexcept {
  for (;;) {
    haply_.update();
    const std::int64_t now = now_ns();
    const bool is_worth_waiting = haply_.is_waiting_for_reply() && now < deadline_ns + patience_ns;
    if (now >= deadline_ns && !is_worth_waiting) return;
    haply_.wait_until(now < deadline_ns ? deadline_ns : deadline_ns + patience_ns);
  }
}

HandleReading HaplyInput::read() noexcept {
  if (const std::uint32_t asked = confirmations_; std::exchange(seen_confirmations_, asked) != asked && !is_armed_) {
    haply_.confirm_zero_pose();
  }
  const HaplyReport& report = haply_.report();
  const std::int64_t now = now_ns();
  const double age_s = static_cast<double>(now - haply_.position_time_ns()) * 1e-9;
  reading_.is_known = report.is_readable() && age_s <= longest_known_s;
  reading_.time_ns = haply_.position_time_ns();
  if (reading_.is_known) {
    speed_.add(report.position, haply_.position_heard_ns());
    reading_.position = plane().in_scene(report.position);
    if (const auto& pose = haply_.pose()) {
      reading_.pushing_motor = motor_;
      const Vector<2> line = HaplyPlane::turned(line_of_motor(*pose, reading_.pushing_motor));
      reading_.motor_angle = std::atan2(line.y, line.x);
      reading_.linkage = linkage_of(*pose, reading_.pushing_motor);
    }
  } else {
    speed_.forget();
  }
  reading_.speed = speed_.value();
  reading_.deadman_held = false;  // it has no button
  reading_.is_ready = report.is_readable() && report.encoders_move() && report.is_guarded;
  reading_.is_healthy = report.is_fast_enough() && report.worst_exchange_s < Safety::longest_exchange_s;
  reading_.trouble = trouble_of(report);
  reading_.may_still_push = report.may_still_push;
  reading_.waits_for_zero_pose = report.state == HaplyState::zero_pose;
  reading_.is_saturated = report.is_saturated;
  check();
  probe();
  estimate_heat(now);
  reports_.publish(report);
  return reading_;
}

// The motor that pushes alone comes first.
LinkagePose HaplyInput::linkage_of(const PantographPose& pose, std::size_t pushing) const noexcept {
  const std::array<Vector<2>, 2> motors{Vector<2>(0.0), {haply_.calibration().geometry.base, 0.0}};
  LinkagePose linkage;
  linkage.motor_count = 1;
  for (const std::size_t arm : {pushing, 1 - pushing}) {
    const std::size_t first = arm == pushing ? 0 : 1;
    linkage.joints[first] = plane().in_scene(motors[arm]);
    linkage.joints[first + 2] = plane().in_scene(pose.elbows[arm]);
    linkage.links[2 * first] = {first, first + 2, false};
    linkage.links[2 * first + 1] = {first + 2, 4, false};
  }
  linkage.joints[4] = plane().in_scene(pose.handle);
  linkage.joint_count = 5;
  linkage.link_count = 4;
  return linkage;
}

// What has come since the last call.
void HaplyInput::check() noexcept {
  const HaplyReport& report = haply_.report();
  const HaplyCalibration& calibration = haply_.calibration();
  const bool has_reply = reading_.is_known && haply_.position_heard_ns() != checked_ns_;
  const Vector<3> angles(report.angles[0], report.angles[1], 0.0);
  bool is_frozen = false;
  if (const auto& pose = haply_.pose(); has_reply && pose) {
    checked_ns_ = haply_.position_heard_ns();
    Vector<3> torques(0.0);
    Vector<3> levers(1.0);
    double strongest = force_limit_;
    double step_rad = 0.0;
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const HaplyArm& known = calibration.arms[arm];
      const auto axis = static_cast<glm::length_t>(arm);
      levers[axis] = std::abs(levers_of(*pose)[arm]);
      torques[axis] = (known.is_motor_reversed ? -1.0 : 1.0) * known.torque_scale * report.torques[arm];
      strongest = std::min(strongest, hapi::greatest_torque * known.torque_scale / std::abs(levers[axis]));
      // Some boards see every other edge alone, and count in double steps.
      step_rad = std::max(step_rad, 2.0 * 2.0 * std::numbers::pi / known.counts_per_turn);
    }
    motor_check_.set_force_limit(strongest);
    // The reply belongs to the command that went out last: the arms were there when it began to act.
    motor_check_.add({.time_ns = haply_.position_time_ns(), .angles = angles, .torques = torques}, step_rad, levers);
    is_frozen = has_frozen_encoder();
  }
  encoder_watch_.update(angles, has_reply, glm::length(standing_), now_ns());
  reading_.is_still = motor_check_.is_still();
  reading_.is_checked = motor_check_.verdict() == MotorVerdict::right;
  const bool do_not_match =
      motor_check_.verdict() == MotorVerdict::wrong || motor_check_.verdict() == MotorVerdict::silent;
  if (is_armed_ && reading_.trouble == OffReason::none && (do_not_match || is_frozen || encoder_watch_.is_frozen())) {
    reading_.trouble = OffReason::calibration;
  }
}

bool HaplyInput::has_frozen_encoder() noexcept {
  const std::array<double, 2>& angles = haply_.report().angles;
  bool is_frozen = false;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    StillEncoder& still = still_encoders_[arm];
    const double other = angles[1 - arm];
    if (!is_armed_ || angles[arm] != still.angle) still = {angles[arm], other, other};
    still.other_least = std::min(still.other_least, other);
    still.other_greatest = std::max(still.other_greatest, other);
    is_frozen |= still.other_greatest - still.other_least > frozen_rad;
  }
  return is_frozen;
}

// What the checks want to be pushed with now.
void HaplyInput::probe() noexcept {
  reading_.probe = Vector<2>(0.0);
  const auto& pose = haply_.pose();
  if (!is_armed_ || !reading_.is_known || !pose) return;
  const MotorCheck::Push push = motor_check_.push_at(now_ns());
  if (push.force != 0.0) {
    reading_.probe = push.force * HaplyPlane::turned(line_of_motor(*pose, push.leg));
  } else if (encoder_watch_.is_asking()) {
    if (asked_way_ == Vector<2>(0.0)) asked_way_ = glm::normalize(standing_);
    reading_.probe = encoder_watch_.force_at(now_ns()) * asked_way_;
  }
  if (!encoder_watch_.is_asking()) asked_way_ = Vector<2>(0.0);
}

// What was sent last has stood since the call before, or has been replaced within that tick.
void HaplyInput::estimate_heat(std::int64_t now_ns) noexcept {
  const std::int64_t before_ns = std::exchange(heat_ns_, now_ns);
  if (before_ns == 0) return;
  for (std::size_t motor = 0; motor < heat_.size(); ++motor) {
    heat_[motor].hold(haply_.report().torques[motor] / hapi::greatest_torque,
                      static_cast<double>(now_ns - before_ns) * 1e-9);
    reading_.heat[motor] = heat_[motor].heat();
  }
}

void HaplyInput::set_force(const Vector<2>& force, bool is_armed) noexcept {
  if (is_armed != is_armed_) {
    is_armed_ = is_armed;
    encoder_watch_.reset();
    if (is_armed) {
      motor_check_.begin();
    } else {
      motor_check_.end();
    }
  }
  standing_ = is_armed ? force - reading_.probe : Vector<2>(0.0);
  haply_.set_force(HaplyPlane::turned(force), is_armed);
}

double HaplyInput::force_uncertainty() const noexcept {
  const auto& arms = haply_.calibration().arms;
  const bool is_measured = arms[0].torque_scale != 1.0 && arms[1].torque_scale != 1.0;
  return is_measured ? measured_uncertainty : unmeasured_uncertainty;
}

void HaplyInput::shut_down() noexcept {
  haply_.shut_down();
  reports_.publish(haply_.report());
}

}  // namespace ghostforce
