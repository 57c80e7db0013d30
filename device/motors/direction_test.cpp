#include "device/motors/direction_test.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghostforce {
namespace {

// By Thue and Morse: sums of these with the powers 0, 1 and 2 of their places are zero.
constexpr std::array<double, DirectionTest::pulse_count> pulse_signs{1.0, -1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0};

// A reply that is missing for longer leaves a hole in what was listened to [ns].
constexpr std::int64_t longest_gap_of_train_ns = 10'000'000;
// A reply tells what the arms did a moment ago: a train is judged by the first that is so much later than its end [s].
constexpr double reply_s = 0.001;
// Of the torque that was asked for: a train with less has told nothing.
constexpr double least_torque_share = 0.5;
// What a wrong motor has given at any time is below zero, but for this share of the most that it has taken.
constexpr double greatest_gain = 0.2;
// How alike the ways of two trains are, as a cosine.
constexpr double least_likeness = 0.8;
// A handle that drifts so far in a train, as a share of how far its motor has moved it, is led by the hand.
constexpr double greatest_drift = 1.0;
// Of what two rounds have found of motors that are crossed, as a share.
constexpr double greatest_difference = 0.3;
// Trains of a lively hand that tell nothing, before the test goes on.
constexpr int most_unclear_trains = 2;

double seconds_of_train(std::int64_t ns) noexcept {
  return static_cast<double>(ns) * 1e-9;
}

// Where a time since the train's beginning belongs. Beyond its end: the last pulse.
std::size_t pulse_at(double time_s) noexcept {
  const double pulse = std::max(0.0, time_s) / DirectionTest::pulse_s;
  return std::min(static_cast<std::size_t>(pulse), DirectionTest::pulse_count - 1);
}

// How much later than this the train ends, as a share of it: what a movement adds to the mean of the energy.
double share_left(double time_s) noexcept {
  return std::clamp(1.0 - time_s / DirectionTest::train_s, 0.0, 1.0);
}

template <typename Values>
double product(const Values& a, const Values& b) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

void DirectionTest::begin() noexcept {
  end();
  is_running_ = true;
}

void DirectionTest::end() noexcept {
  if (is_pushing_) ended_ns_ = before_.time_ns;
  is_running_ = is_pushing_ = is_done_ = false;
  knows_own_ = false;
  finding_ = {};
  leg_ = 0;
  sign_ = 1.0;
  wrong_trains_ = unclear_trains_ = crossed_rounds_ = 0;
  is_right_ = {};
  found_ = {};
}

void DirectionTest::add(const MotorCheck::Reading& reading, double count_angle, const Vector<3>& levers,
                        bool is_still) noexcept {
  const bool is_gap = has_reading_ && reading.time_ns - before_.time_ns > longest_gap_of_train_ns;
  is_still_ = is_still;
  levers_ = levers;
  count_angle_ = count_angle;
  if (is_gap) {
    rest_count_ = 0;
    if (is_pushing_) ended_ns_ = reading.time_ns;
    is_pushing_ = false;
  }
  if (!is_pushing_) {
    follow_rest(reading);
  } else {
    const auto axis = static_cast<glm::length_t>(leg_);
    const double time_s = seconds_of_train(before_.time_ns - began_ns_);
    const double lasts_s = seconds_of_train(reading.time_ns - before_.time_ns);
    const double torque = before_.torques[axis];
    const double turned = reading.angles[axis] - before_.angles[axis];
    const double weight = torque * share_left(time_s);
    const std::size_t pulse = pulse_at(time_s);
    train_.energy[pulse] += torque * turned;
    train_.impulse[pulse] += torque * lasts_s;
    train_.mean_energy += weight * (reading.angles - before_.angles);
    train_.mean_impulse += weight * lasts_s;
    train_.torque += std::abs(torque) * lasts_s;
    train_.roughness += (weight - train_.weight_before) * (weight - train_.weight_before);
    train_.weight_before = weight;
    for (std::size_t i = pulse; i < pulse_count; ++i) train_.way[i] = sign_ * (reading.angles[axis] - start_[axis]);
  }
  before_ = reading;
  has_reading_ = true;
  if (!is_pushing_ || seconds_of_train(reading.time_ns - began_ns_) < train_s + reply_s) return;
  is_pushing_ = false;
  ended_ns_ = reading.time_ns;
  rest_count_ = 0;
  take_in(outcome_of_train());
}

MotorCheck::Push DirectionTest::push_at(std::int64_t now_ns) noexcept {
  if (!is_running_ || is_done_ || finding_.verdict != MotorVerdict::none) return {};
  if (!is_pushing_) {
    if (!has_reading_ || !is_still_ || seconds_of_train(now_ns - ended_ns_) < rest_s) return {};
    if (leg_ == legs_) {
      is_done_ = !are_crossed();
      if (is_done_) return {};
      if (++crossed_rounds_ >= crossed_rounds_to_tell) {
        finding_ = {MotorVerdict::crossed, 0};
        return {};
      }
      begin_leg(0);  // once more, from the other side
    }
    if (!knows_own_) knows_own_ = learn_own();
    if (!knows_own_) return {};
    is_pushing_ = true;
    began_ns_ = now_ns;
    start_ = before_.angles;
    train_ = {};
  }
  const double time_s = seconds_of_train(now_ns - began_ns_);
  if (time_s >= train_s) return {};
  const double lever = levers_[static_cast<glm::length_t>(leg_)];
  const double force = std::min({greatest_torque / lever, greatest_force, limit_});
  return {leg_, sign_ * pulse_signs[pulse_at(time_s)] * force};
}

void DirectionTest::follow_rest(const MotorCheck::Reading& reading) noexcept {
  if (rest_count_ > 0) {
    const Place& newest = rest_[(rest_next_ + rest_size - 1) % rest_size];
    if (reading.time_ns - newest.time_ns < rest_step_ns) return;
  }
  rest_[rest_next_] = {reading.time_ns, reading.angles};
  rest_next_ = (rest_next_ + 1) % rest_size;
  rest_count_ = std::min(rest_count_ + 1, rest_size);
}

// The greatest that a train would have found in what the hand did by itself in the last second. False: it has not been
// watched for so long.
bool DirectionTest::learn_own() noexcept {
  own_ = Vector<3>(0.0);
  for (int shift = 0; shift < own_shifts; ++shift) {
    const std::int64_t end_ns = before_.time_ns - shift * own_shift_ns;
    const std::int64_t start_ns = end_ns - static_cast<std::int64_t>(train_s * 1e9);
    Vector<3> sum(0.0);
    bool is_whole = false;
    for (std::size_t back = 1; back < rest_count_; ++back) {
      const Place& to = rest_[(rest_next_ + rest_size - back) % rest_size];
      const Place& from = rest_[(rest_next_ + rest_size - back - 1) % rest_size];
      if (from.time_ns > end_ns) continue;
      is_whole = from.time_ns <= start_ns;
      if (is_whole) break;
      const double time_s = seconds_of_train(from.time_ns - start_ns);
      sum += pulse_signs[pulse_at(time_s)] * share_left(time_s) * (to.angles - from.angles);
    }
    // One that has been watched for one train is known well enough.
    if (!is_whole) return shift > 0;
    for (glm::length_t axis = 0; axis < 3; ++axis) own_[axis] = std::max(own_[axis], std::abs(sum[axis]));
  }
  return true;
}

DirectionTest::Outcome DirectionTest::outcome_of_train() noexcept {
  const double torque = train_.torque / train_s;
  const auto axis = static_cast<glm::length_t>(leg_);
  const double asked = std::min({greatest_torque, greatest_force * levers_[axis], limit_ * levers_[axis]});
  found_[leg_] = {};
  if (!(torque >= least_torque_share * asked)) return Outcome::unclear_and_quiet;
  const double of_steps = 3.0 * count_angle_ * std::sqrt(train_.roughness / 12.0);
  const double of_hand = 2.0 * own_[axis] * torque;
  const double margin = of_steps + of_hand;
  found_[leg_] = {.energy = train_.mean_energy / (torque * torque),
                  .margin = (of_steps + 2.0 * std::max({own_.x, own_.y, own_.z}) * torque) / (torque * torque)};
  // Without what an even drift has added: but for it, the places after the first four pulses have the others' mean.
  constexpr std::size_t half = pulse_count / 2;
  double sums = 0.0;
  for (std::size_t i = 0; i < half; ++i) sums += train_.way[i + half] - train_.way[i];
  const double drift = sums / static_cast<double>(half * half) / pulse_s;
  const double energy = train_.mean_energy[axis] - sign_ * drift * train_.mean_impulse;
  if (energy > margin) return Outcome::right;
  const Outcome unclear = of_hand <= of_steps ? Outcome::unclear_and_quiet : Outcome::unclear;
  if (energy >= -margin) return unclear;
  double given = 0.0;
  double least = 0.0;
  double greatest = 0.0;
  double farthest = 0.0;
  for (std::size_t i = 0; i < pulse_count; ++i) {
    train_.way[i] -= drift * pulse_s * static_cast<double>(i + 1);
    given += train_.energy[i] - sign_ * drift * train_.impulse[i];
    least = std::min(least, given);
    greatest = std::max(greatest, given);
    farthest = std::max(farthest, std::abs(train_.way[i]));
  }
  // From its middle on: the next train may begin before the handle is back where this one has found it.
  double sum = 0.0;
  for (const double way : train_.way) sum += way;
  for (double& way : train_.way) way -= sum / static_cast<double>(pulse_count);
  const bool is_led = std::abs(drift) * train_s > greatest_drift * farthest;
  return !is_led && greatest <= -greatest_gain * least ? Outcome::wrong : Outcome::unclear;
}

// Two motors against each other: a hand gives back no more than it got from both, so that what each would have given to
// the other one's arm is no more than what both have given to their own. Where they are crossed, it is as much more in
// each round.
bool DirectionTest::are_crossed() noexcept {
  const std::size_t pairs = legs_ == 2 ? 1 : legs_;
  double least = 0.0;
  for (std::size_t one = 0; one < pairs; ++one) {
    const std::size_t other = (one + 1) % legs_;
    const auto i = static_cast<glm::length_t>(one);
    const auto k = static_cast<glm::length_t>(other);
    if (found_[one].margin == 0.0 || found_[other].margin == 0.0) continue;
    const double margin = 2.0 * (found_[one].margin + found_[other].margin);
    const double own = found_[one].energy[i] + found_[other].energy[k];
    const double crossed = found_[one].energy[k] + found_[other].energy[i];
    if (own - crossed < -margin && own + crossed > margin) least = std::min(least, own - crossed);
  }
  const double before = std::exchange(crossed_energy_, least);
  if (least == 0.0) return false;
  return crossed_rounds_ == 0 || std::abs(least - before) < greatest_difference * std::abs(before);
}

void DirectionTest::take_in(Outcome outcome) noexcept {
  if (outcome == Outcome::wrong) {
    const double likeness = product(train_.way, way_before_) /
                            std::sqrt(product(train_.way, train_.way) * product(way_before_, way_before_));
    if (wrong_trains_ > 0 && !(likeness >= least_likeness)) outcome = Outcome::unclear;
  }
  switch (outcome) {
    case Outcome::right:
      is_right_[leg_] = true;
      begin_leg(leg_ + 1);
      return;
    case Outcome::unclear_and_quiet:
      begin_leg(leg_ + 1);
      return;
    case Outcome::wrong:
      way_before_ = train_.way;
      sign_ = -sign_;
      if (++wrong_trains_ >= trains_to_tell) finding_ = {MotorVerdict::wrong_way, leg_};
      return;
    case Outcome::unclear:
      wrong_trains_ = 0;
      knows_own_ = false;  // it may have come to rest just before this
      found_[leg_] = {};
      if (++unclear_trains_ >= most_unclear_trains) begin_leg(leg_ + 1);
      return;
  }
}

void DirectionTest::begin_leg(std::size_t leg) noexcept {
  leg_ = leg;
  wrong_trains_ = unclear_trains_ = 0;
  sign_ = crossed_rounds_ % 2 == 0 ? 1.0 : -1.0;
}

}  // namespace ghostforce
