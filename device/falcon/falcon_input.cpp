#include "device/falcon/falcon_input.h"

#include <algorithm>
#include <utility>

#include <glm/gtc/matrix_access.hpp>

#include "core/scene.h"

namespace ghostforce {
namespace {

// A reply that is about to come is waited for this long after a tick is due [ns].
constexpr std::int64_t patience_ns = 1'000'000;

// An older position is none [s].
constexpr double longest_known_s = Safety::longest_exchange_s;

OffReason trouble_of(const FalconReport& report) noexcept {
  switch (report.state) {
    case FalconState::idle:
    case FalconState::active:
      return OffReason::none;
    case FalconState::homing:
    case FalconState::opening:
    case FalconState::loading_firmware:
      return OffReason::not_homed;
    case FalconState::absent:
      return OffReason::unplugged;
    case FalconState::fault:
      if (report.fault == FalconFault::unplugged) return OffReason::unplugged;
      return report.fault == FalconFault::overruled ? OffReason::overruled : OffReason::fault;
  }
  return OffReason::fault;
}

}  // namespace

FalconInput::FalconInput(std::unique_ptr<FalconLink> link, FalconOptions options, const Vector<2>& view_center)
    : falcon_(std::move(link), std::move(options)), view_center_(view_center) {}

void FalconInput::restart(const Vector<2>& goal) noexcept {
  goal_.restart(goal);
}

Vector<2> FalconInput::goal(std::int64_t /*tick*/, double rate) noexcept {
  return reading_.is_known ? goal_.next(reading_.position, rate) : goal_.waiting();
}

void FalconInput::wait_until(std::int64_t deadline_ns) noexcept {
  for (;;) {
    falcon_.update();
    const std::int64_t now = now_ns();
    const bool is_worth_waiting = falcon_.is_waiting_for_reply() && now < deadline_ns + patience_ns;
    if (now >= deadline_ns && !is_worth_waiting) return;
    falcon_.wait_until(now < deadline_ns ? deadline_ns : deadline_ns + patience_ns);
  }
}

HandleReading FalconInput::read() noexcept {
  const FalconReport& report = falcon_.report();
  const std::int64_t now = now_ns();
  const double age_s = static_cast<double>(now - falcon_.position_time_ns()) * 1e-9;
  reading_.is_known = report.is_readable() && age_s <= longest_known_s;
  reading_.time_ns = falcon_.position_time_ns();
  if (reading_.is_known) {
    speed_.add(report.position, falcon_.position_heard_ns());
    reading_.position = plane().in_scene(report.position);
  } else {
    speed_.forget();
  }
  reading_.speed = speed_.value();
  reading_.deadman_held = report.buttons != 0;
  reading_.is_ready = report.is_readable() && report.encoders_move() && report.is_guarded;
  reading_.is_healthy = report.is_fast_enough() && report.worst_exchange_s < Safety::longest_exchange_s;
  reading_.trouble = trouble_of(report);
  reading_.may_still_push = report.may_still_push;
  check();
  probe();
  estimate_heat(now);
  reports_.publish(report);
  return reading_;
}

// What has come since the last call.
void FalconInput::check() noexcept {
  const FalconReport& report = falcon_.report();
  const FalconCalibration& calibration = falcon_.calibration();
  const bool has_reply = reading_.is_known && falcon_.position_heard_ns() != checked_ns_;
  const std::optional<Matrix<3>> jacobian = has_reply ? falcon_.jacobian() : std::nullopt;
  if (jacobian) {
    checked_ns_ = falcon_.position_heard_ns();
    Vector<3> levers;
    for (glm::length_t leg = 0; leg < 3; ++leg) levers[leg] = 1.0 / glm::length(glm::row(*jacobian, leg));
    // The reply belongs to the command that went out last: the arms were there when it began to act. Positive counts pull
    // an arm in.
    const Vector<3> pulls = in_leg_order(vector_of(report.motors), calibration.motor_of_leg);
    motor_check_.add({.time_ns = falcon_.position_time_ns(),
                      .angles = joint_angles(report.encoders, calibration),
                      .torques = -pulls / motor_constants(calibration)},
                     radians_per_count(calibration.geometry), levers);
  }
  encoder_watch_.update(vector_of(report.encoders), has_reply, glm::length(standing_), now_ns());
  reading_.is_still = motor_check_.is_still();
  reading_.is_checked = motor_check_.verdict() == MotorVerdict::right;
  const bool do_not_match = has_failed(motor_check_.verdict());
  if (is_armed_ && reading_.trouble == OffReason::none && (do_not_match || encoder_watch_.is_frozen())) {
    reading_.trouble = OffReason::calibration;
  }
}

// What the checks want to be pushed with now.
void FalconInput::probe() noexcept {
  reading_.probe = Vector<2>(0.0);
  if (!is_armed_ || !reading_.is_known) return;
  const MotorCheck::Push push = motor_check_.push_at(now_ns());
  if (push.force != 0.0) {
    pushed_way_ = way_of_leg(push.leg).value_or(Vector<3>(0.0));
    reading_.probe = push.force * plane().along(pushed_way_);
  } else if (encoder_watch_.is_asking()) {
    if (asked_way_ == Vector<2>(0.0)) asked_way_ = glm::normalize(standing_);
    reading_.probe = encoder_watch_.force_at(now_ns()) * asked_way_;
  }
  if (!encoder_watch_.is_asking()) asked_way_ = Vector<2>(0.0);
}

// What was sent last has stood since the call before, or has been replaced within that tick.
void FalconInput::estimate_heat(std::int64_t now_ns) noexcept {
  const std::int64_t before_ns = std::exchange(heat_ns_, now_ns);
  if (before_ns == 0) return;
  for (std::size_t motor = 0; motor < heat_.size(); ++motor) {
    heat_[motor].hold(falcon_.report().motors[motor] / most_motor_counts,
                      static_cast<double>(now_ns - before_ns) * 1e-9);
    reading_.heat[motor] = heat_[motor].heat();
  }
}

// The direction in which the handle moves a leg the most.
std::optional<Vector<3>> FalconInput::way_of_leg(std::size_t leg) const noexcept {
  const std::optional<Matrix<3>> jacobian = falcon_.jacobian();
  if (!jacobian) return std::nullopt;
  return glm::normalize(glm::row(*jacobian, static_cast<glm::length_t>(leg)));
}

Vector<2> FalconInput::set_force(const Vector<2>& force, bool is_armed) noexcept {
  if (is_armed != is_armed_) {
    is_armed_ = is_armed;
    encoder_watch_.reset();
    pushed_way_ = Vector<3>(0.0);
    if (is_armed) {
      motor_check_.begin();
    } else {
      motor_check_.end();
    }
  }
  standing_ = is_armed ? force - reading_.probe : Vector<2>(0.0);
  Vector<3> on_handle = plane().on_handle(force);
  // As long as motors are checked, nothing else is pushed with: what lies across the plane goes with what lies in it.
  const Vector<2> along = plane().along(pushed_way_);
  if (!reading_.is_checked && along != Vector<2>(0.0)) {
    on_handle = glm::dot(force, along) / glm::dot(along, along) * pushed_way_;
  }
  falcon_.set_force(on_handle, is_armed);
  return force;
}

double FalconInput::force_uncertainty() const noexcept {
  const Vector<3> constants = motor_constants(falcon_.calibration());
  const double used = std::max({constants.x, constants.y, constants.z});
  return used / std::min(used, smallest_published_motor_constant);
}

void FalconInput::shut_down() noexcept {
  falcon_.shut_down();
  reports_.publish(falcon_.report());
}

}  // namespace ghostforce
