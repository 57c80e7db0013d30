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

// One arm turns so far, and the encoder of the other tells not one step: that may be so, and is worth a question [rad].
constexpr double suspicious_rad = 2.0 * radians_per_degree;

// A motor that comes to its limit again and again says so all the while [ns].
constexpr std::int64_t saturated_for_ns = 300'000'000;

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
  if (!report.is_readable()) reading_.linkage.reset();
  // Where nobody knows the links, they are shown as a person is to put them.
  if (report.state == HaplyState::zero_pose) {
    const HaplyCalibration& calibration = haply_.calibration();
    if (const auto pose = pose_at(calibration.geometry, zero_pose_of(calibration))) {
      reading_.linkage = linkage_of(*pose, motor_);
    }
  }
  reading_.speed = speed_.value();
  reading_.deadman_held = false;  // it has no button
  reading_.is_ready = report.is_readable() && report.encoders_move() && report.is_guarded;
  reading_.is_healthy = report.is_fast_enough() && report.worst_exchange_s < Safety::longest_exchange_s;
  reading_.trouble = trouble_of(report);
  if (is_armed_ && report.is_lagging && reading_.trouble == OffReason::none) reading_.trouble = OffReason::loop_late;
  reading_.may_still_push = report.may_still_push;
  reading_.waits_for_zero_pose = report.state == HaplyState::zero_pose;
  reading_.zero_pose_moved = report.zero_pose == ZeroPose::moving;
  if (report.is_saturated) saturated_ns_ = now;
  reading_.is_saturated = saturated_ns_ != 0 && now - saturated_ns_ < saturated_for_ns;
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
      strongest = std::min(strongest, hapi::greatest_torque * known.torque_scale / levers[axis]);
      step_rad = std::max(step_rad, step_of(arm));
    }
    direction_test_.set_force_limit(strongest);
    motor_check_.set_force_limit(strongest);
    // The reply belongs to the command that went out last: the arms were there when it began to act.
    const MotorCheck::Reading reading{
        .time_ns = haply_.position_time_ns(), .angles = {report.angles[0], report.angles[1], 0.0}, .torques = torques};
    motor_check_.add(reading, step_rad, levers);
    direction_test_.add(reading, step_rad, levers, motor_check_.is_still());
  }
  reading_.is_still = motor_check_.is_still();
  reading_.is_checked = motor_check_.verdict() == MotorVerdict::right;
  watch_encoders(has_reply);
  MotorFinding finding = has_begun_check_ ? motor_check_.finding() : direction_test_.finding();
  // It has pushed before: the hand was too firm or too lively for the check.
  if (finding.verdict == MotorVerdict::silent && direction_test_.is_right(finding.motor)) {
    finding.verdict = MotorVerdict::undecided;
  }
  const bool do_not_match = has_failed(finding.verdict);
  const bool is_frozen = std::ranges::any_of(arm_watches_, [](const ArmWatch& arm) { return arm.watch.is_frozen(); });
  if (is_armed_ && reading_.trouble == OffReason::none && (do_not_match || is_frozen)) {
    reading_.trouble = OffReason::calibration;
    if (do_not_match) reading_.finding = finding;
    if (is_frozen) haply_.lose_count();
  }
}

// The smallest movement that this arm's encoder was ever seen to tell. Some boards see every other edge alone, and count in
// double steps: until it has moved, that is assumed [rad].
double HaplyInput::step_of(std::size_t arm) noexcept {
  ArmWatch& known = arm_watches_[arm];
  const double nominal = 2.0 * std::numbers::pi / haply_.calibration().arms[arm].counts_per_turn;
  const double angle = haply_.report().angles[arm];
  const double moved = std::abs(angle - std::exchange(known.angle_before, angle));
  if (known.least_step == 0.0) known.least_step = 2.0 * nominal;
  // A counter tells whole steps; what is less is rounding.
  if (moved > 0.5 * nominal) known.least_step = std::min(known.least_step, std::max(moved, nominal));
  return known.least_step;
}

// Whether each arm's encoder still counts: while a force stands on its motor, and where the other arm turns and this one
// does not. It is asked by its own motor, which has to move it.
void HaplyInput::watch_encoders(bool has_reply) noexcept {
  const HaplyReport& report = haply_.report();
  const auto& pose = haply_.pose();
  const Vector<2> standing = report.workspace_share * HaplyPlane::turned(standing_);
  for (std::size_t arm = 0; arm < 2; ++arm) {
    ArmWatch& watched = arm_watches_[arm];
    const double angle = report.angles[arm];
    const double other = report.angles[1 - arm];
    // Until the motors are checked, it is for those checks to find out.
    if (!is_armed_ || !reading_.is_checked || angle != watched.angle) {
      watched.angle = angle;
      watched.other_least = watched.other_greatest = other;
    }
    watched.other_least = std::min(watched.other_least, other);
    watched.other_greatest = std::max(watched.other_greatest, other);
    const bool is_suspicious = is_armed_ && watched.other_greatest - watched.other_least > suspicious_rad;
    double force = is_suspicious ? EncoderWatch::greatest_force : 0.0;
    if (pose) {
      const double lever = levers_of(*pose)[arm];
      const double along = torques_for(*pose, standing)[arm] / lever;
      if (std::isfinite(along)) force = std::max(force, std::abs(along));
      if (!watched.watch.is_asking()) watched.sign = along < 0.0 ? -1.0 : 1.0;
    }
    watched.watch.update({angle, 0.0, 0.0}, has_reply, force, now_ns());
  }
}

// What the checks want to be pushed with now.
void HaplyInput::probe() noexcept {
  reading_.probe = Vector<2>(0.0);
  const auto& pose = haply_.pose();
  if (!is_armed_ || !reading_.is_known || !pose) return;
  // What pushes gently comes first.
  MotorCheck::Push push = direction_test_.push_at(now_ns());
  if (direction_test_.is_done()) {
    if (!std::exchange(has_begun_check_, true)) motor_check_.begin();
    push = motor_check_.push_at(now_ns());
  }
  if (push.force != 0.0) {
    reading_.probe = push.force * HaplyPlane::turned(line_of_motor(*pose, push.leg));
    return;
  }
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const ArmWatch& watched = arm_watches_[arm];
    if (!watched.watch.is_asking()) continue;
    reading_.probe += watched.sign * watched.watch.force_at(now_ns()) * HaplyPlane::turned(line_of_motor(*pose, arm));
  }
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

Vector<2> HaplyInput::set_force(const Vector<2>& force, bool is_armed) noexcept {
  if (is_armed != is_armed_) {
    is_armed_ = is_armed;
    for (ArmWatch& arm : arm_watches_) arm.watch.reset();
    has_begun_check_ = false;
    motor_check_.end();
    if (is_armed) {
      reading_.finding = {};
      direction_test_.begin();
    } else {
      direction_test_.end();
    }
  }
  standing_ = is_armed ? force - reading_.probe : Vector<2>(0.0);
  return HaplyPlane::turned(haply_.set_force(HaplyPlane::turned(force), is_armed));
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
