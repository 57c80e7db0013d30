#include "device/motors/motor_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ghostforce {
namespace {

constexpr double push_s = 2.0 * MotorCheck::half_s;
constexpr double omega = 2.0 * std::numbers::pi / MotorCheck::half_s;
constexpr double seconds_per_ns = 1e-9;
// A reply that is missing for longer leaves a hole in what was listened to [ns].
constexpr std::int64_t longest_gap_ns = 10'000'000;
// Energy of a push with a = 1 N at a hand of 0.3 kg and 10 N·s/m: what a lively hand adds by itself must stay below it [J].
constexpr double usual_energy = 66e-6;
// In a push: fewer come too late to tell of it.
constexpr std::size_t least_replies = 40;
// How far a handle may be from where it was after a push, for a = 1 N; the liveliest resonance of a light one [m].
constexpr double longest_stray_per_force = 1.7e-3;
// Pushes that move nothing, each with all force.
constexpr int silent_tries_to_tell = 4;
// Pushes, each stronger than the one before, during which no encoder counts at all.
constexpr int mute_tries_to_tell = 2;
// Of a verdict's two halves the smaller one is at least this share of the greater one [1].
constexpr double agreement = 0.2;
// Mean magnitude of f for a = 1 [1].
constexpr double mean_force = 0.68;

// f(t) for a = 1.
double shape(double time_s) noexcept {
  if (time_s < 0.0 || time_s >= push_s) return 0.0;
  const double sign = time_s < MotorCheck::half_s ? 1.0 : -1.0;
  return sign * (std::sin(2.0 * omega * time_s) - 0.5 * std::sin(omega * time_s));
}

int sign_beyond(double energy, double margin) noexcept {
  return energy > margin ? 1 : energy < -margin ? -1 : 0;
}

double seconds(std::int64_t ns) noexcept {
  return static_cast<double>(ns) * seconds_per_ns;
}

}  // namespace

MotorCheck::MotorCheck(std::size_t legs) noexcept : legs_(legs) {
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const double time_s = push_s * static_cast<double>(i) / static_cast<double>(weights_.size() - 1);
    weights_[i] = shape(time_s) * (1.0 - time_s / push_s);
  }
}

void MotorCheck::begin() noexcept {
  end();
  is_running_ = true;
}

void MotorCheck::end() noexcept {
  if (force_ != 0.0) ended_ns_ = back(0).time_ns;
  is_running_ = false;
  leg_ = 0;
  force_ = 0.0;
  needs_rest_ = true;
  tries_ = votes_ = silent_tries_ = 0;
  unclear_energy_ = unclear_margin_ = 0.0;
  rounds_ = 0;
  verdict_ = MotorVerdict::none;
}

void MotorCheck::add(const Reading& reading, double count_angle, const Vector<3>& levers) noexcept {
  if (count_ > 0 && reading.time_ns - back(0).time_ns > longest_gap_ns) count_ = 0;
  history_[next_] = reading;
  next_ = (next_ + 1) % history_size;
  count_ = std::min(count_ + 1, history_size);
  count_angle_ = count_angle;
  levers_ = levers;
  if (verdict_ != MotorVerdict::none) return;
  if (force_ == 0.0) {
    own_ = 0.0;
    for (std::size_t leg = 0; leg < legs_; ++leg) own_ = std::max(own_, own_energy(leg));
    is_still_ = 2.0 * own_ <= usual_energy * greatest_force;
  } else if (seconds(reading.time_ns - began_ns_) >= push_s + 0.001) {
    ended_ns_ = reading.time_ns;
    judge(energy_of_push());
  }
}

MotorCheck::Push MotorCheck::push_at(std::int64_t now_ns) noexcept {
  if (!is_running_ || verdict_ != MotorVerdict::none) return {};
  if (force_ == 0.0) {
    if (needs_rest_ && (!is_still_ || seconds(now_ns - ended_ns_) < rest_s)) return {};
    force_ = std::clamp(std::max(least_force * (1.0 + tries_), 2.0 * own_ / usual_energy), least_force, greatest_force);
    force_ = std::min(force_, limit_ / crest);
    began_ns_ = now_ns;
  }
  return {leg_, force_ * shape(seconds(now_ns - began_ns_))};
}

// What this leg's push, with a = 1 N, would have got from the hand's own motion: the greatest of what it would have got
// in the last milliseconds [J].
double MotorCheck::own_energy(std::size_t leg) const noexcept {
  constexpr std::int64_t step_ns = 10'000'000;
  const auto axis = static_cast<glm::length_t>(leg);
  double greatest = 0.0;
  for (int shift = 0; shift < 4; ++shift) {
    const std::int64_t end_ns = back(0).time_ns - shift * step_ns;
    const std::int64_t start_ns = end_ns - static_cast<std::int64_t>(push_s * 1e9);
    double sum = 0.0;
    std::size_t steps = 0;
    while (steps + 1 < count_ && back(steps).time_ns > end_ns) ++steps;
    for (; back(steps).time_ns > start_ns; ++steps) {
      if (steps + 1 >= count_) return std::numeric_limits<double>::infinity();
      const Reading& from = back(steps + 1);
      const double share = seconds(from.time_ns - start_ns) / push_s;
      const auto at = static_cast<std::size_t>(std::max(0.0, share) * static_cast<double>(weight_count - 1));
      sum += weights_[std::min(at, weight_count - 1)] * (back(steps).angles[axis] - from.angles[axis]);
    }
    greatest = std::max(greatest, std::abs(sum) * levers_[axis]);
  }
  return greatest;
}

MotorCheck::Energy MotorCheck::energy_of_push() const noexcept {
  Energy energy;
  const auto axis = static_cast<glm::length_t>(leg_);
  Vector<2> halves{0.0};  // turned in each [rad]
  double later_weight = 0.0;
  double roughness = 0.0;
  double impulse = 0.0;
  std::size_t steps = 0;
  for (; back(steps).time_ns > began_ns_; ++steps) {
    if (steps + 1 >= count_) return energy;
    const Reading& from = back(steps + 1);
    const double time_s = seconds(from.time_ns - began_ns_);
    const double torque = from.torques[axis];
    const Vector<3> turned = back(steps).angles - from.angles;
    const double weight = torque * std::max(0.0, 1.0 - time_s / push_s);
    energy.at_legs += weight * turned;
    halves[time_s < half_s ? 0 : 1] += turned[axis];
    if (time_s < half_s) {
      energy.first += torque * (1.0 - time_s / half_s) * turned[axis];
    } else {
      energy.second += torque * std::max(0.0, 2.0 - time_s / half_s) * turned[axis];
    }
    energy.has_moved |= turned != Vector<3>(0.0);
    impulse += std::abs(torque) * seconds(back(steps).time_ns - from.time_ns);
    roughness += (later_weight - weight) * (later_weight - weight);
    later_weight = weight;
  }
  energy.whole = energy.at_legs[axis];
  energy.torque = impulse / push_s;
  // A shorter limit of force makes it weaker.
  const double share = energy.torque / (force_ * mean_force * levers_[axis]);
  const double of_steps = 3.0 * count_angle_ * std::sqrt(roughness / 12.0);
  const double of_hand = 2.0 * own_ * force_ * std::min(share, 1.0);
  energy.margin = of_steps + of_hand;
  energy.is_quiet = of_hand <= of_steps;
  // A push leaves a handle where it was after each of its halves, or nearly so. A hand has set off meanwhile if not.
  const double set_off = std::abs(halves.y - halves.x) * levers_[axis];
  energy.is_valid = share > 0.25 && steps >= least_replies && set_off <= longest_stray_per_force * force_;
  return energy;
}

void MotorCheck::judge(const Energy& energy) noexcept {
  force_ = 0.0;
  needs_rest_ = true;
  if (!energy.is_valid) return;
  newest_ = energy;
  ++tries_;
  unclear_energy_ += energy.whole;
  unclear_margin_ = std::hypot(unclear_margin_, energy.margin);
  int sign = sign_beyond(energy.whole, energy.margin);
  if (sign == 0 && sign_beyond(unclear_energy_, unclear_margin_) == 0) {
    needs_rest_ = energy.has_moved;
    silent_tries_ = energy.is_quiet && tries_ > 2 ? silent_tries_ + 1 : 0;
    const bool is_mute = !energy.has_moved && tries_ >= mute_tries_to_tell;
    if (is_mute || silent_tries_ >= silent_tries_to_tell) verdict_ = MotorVerdict::silent;
    return;
  }
  // Many that are too weak to tell may tell together.
  if (sign == 0) sign = sign_beyond(unclear_energy_, unclear_margin_);
  silent_tries_ = 0;
  unclear_energy_ = unclear_margin_ = 0.0;
  const double smaller = std::min(sign * energy.first, sign * energy.second);
  const double greater = std::max(sign * energy.first, sign * energy.second);
  const bool is_strong = std::abs(energy.whole) > 2.0 * energy.margin && smaller > agreement * greater;
  votes_ = (sign * votes_ > 0 ? votes_ : 0) + (is_strong ? 2 * sign : sign);
  if (votes_ <= -2) verdict_ = MotorVerdict::wrong_way;
  if (votes_ < 2) return;
  found_[leg_] = energy;
  tries_ = votes_ = 0;
  if (++leg_ < legs_) return;
  leg_ = 0;
  verdict_ = verdict_on_legs();
  // A hand that cannot be told apart from mixed up motors so often is not waited for for ever.
  if (verdict_ == MotorVerdict::none && ++rounds_ >= most_rounds) verdict_ = MotorVerdict::undecided;
}

// Two motors against each other, added up from the pushes of one after the other: a hand gives back no more than it got
// from both. None: too close to tell.
MotorVerdict MotorCheck::verdict_on_legs() const noexcept {
  const std::size_t pairs = legs_ == 2 ? 1 : legs_;
  std::size_t agreeing = 0;
  for (std::size_t one = 0; one < pairs; ++one) {
    const std::size_t other = (one + 1) % legs_;
    double energy = 0.0;
    double margin = 0.0;
    for (const auto& [pushed, against] : {std::pair(one, other), std::pair(other, one)}) {
      const Energy& found = found_[pushed];
      const double per_force = 1.0 / (found.torque * found.torque);
      const Vector<3>& at = found.at_legs;
      energy += per_force * (at[static_cast<glm::length_t>(pushed)] - at[static_cast<glm::length_t>(against)]);
      margin += per_force * found.margin;
    }
    const int sign = sign_beyond(energy, margin);
    if (sign < 0) return MotorVerdict::crossed;
    agreeing += sign > 0 ? 1 : 0;
  }
  return agreeing == pairs ? MotorVerdict::right : MotorVerdict::none;
}

}  // namespace ghostforce
