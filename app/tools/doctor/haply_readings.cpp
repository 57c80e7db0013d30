#include "app/tools/doctor/haply_readings.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ghostforce {
namespace {

constexpr std::array straight_deg{90.0, 90.0};
constexpr std::array outwards_deg{180.0, 0.0};

// Two right angles by eye, each to about 2°: what is read within this of what it should be says nothing against it.
constexpr double eye_share = 0.05;
constexpr double eye_deg = 4.0;
constexpr double least_turn_deg = 10.0;

}  // namespace

std::string_view words_of(HaplyWiringProblem problem) noexcept {
  switch (problem) {
    case HaplyWiringProblem::none:
      return "";
    case HaplyWiringProblem::no_movement:
      return "At least one of them did not move. Check its plug and the power supply, and measure again.";
    case HaplyWiringProblem::both_moved:
      return "Both moved in one turn. Hold the other arm still, and measure again.";
    case HaplyWiringProblem::same_twice:
      return "The same one moved both times. Keep the other arm still, and measure again.";
    case HaplyWiringProblem::odd_size:
      return "A right angle was read as something that no wrong counts per turn explain. Measure again.";
  }
  return "";
}

HaplyEncoders find_haply_encoders(const std::array<HaplyTurn, 2>& turns, const HaplyCalibration& assumed) noexcept {
  HaplyEncoders found;
  found.calibration = assumed;
  const auto no_encoders = [&](HaplyWiringProblem problem) {
    HaplyEncoders none;
    none.problem = problem;
    none.calibration = assumed;
    return none;
  };
  std::array<std::size_t, 2> ports{};
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const HaplyTurn& turn = turns[arm];
    const hapi::PerPort<double> change{turn.outwards[0] - turn.straight[0], turn.outwards[1] - turn.straight[1]};
    const std::size_t port = std::abs(change[1]) > std::abs(change[0]) ? 1 : 0;
    if (std::abs(change[port]) < least_turn_deg) return no_encoders(HaplyWiringProblem::no_movement);
    if (std::abs(change[1 - port]) > 0.5 * std::abs(change[port])) return no_encoders(HaplyWiringProblem::both_moved);
    ports[arm] = port;
    // The arm under whose name the board was told of this encoder.
    const HaplyArm& told = assumed.arms[assumed.arms[0].encoder_port - 1U == port ? 0 : 1];
    const double ratio = change[port] / (outwards_deg[arm] - straight_deg[arm]);
    const double size = std::abs(ratio);
    double factor = size;
    for (const double plain : {1.0, 0.5, 2.0}) {
      if (std::abs(size / plain - 1.0) <= eye_share) factor = plain;
    }
    if (!(factor > 0.2 && factor < 5.0)) return no_encoders(HaplyWiringProblem::odd_size);
    HaplyArm& known = found.calibration.arms[arm];
    found.ratios[arm] = ratio;
    found.factors[arm] = factor;
    known.encoder_port = told.encoder_port;
    known.encoder_direction = ratio < 0.0 ? 1U - told.encoder_direction : told.encoder_direction;
    known.counts_per_turn = std::clamp(told.counts_per_turn * factor, 100.0, 200000.0);
    // What it would have told, set up rightly, with the arm's own angle in the zero pose.
    const double share = ratio < 0.0 ? -factor : factor;
    const auto right = [&](double read_deg) { return known.offset_deg + (read_deg - told.offset_deg) / share; };
    const double off =
        0.5 * (right(turn.straight[port]) - straight_deg[arm] + right(turn.outwards[port]) - outwards_deg[arm]);
    found.off_deg[arm] = off;
    if (std::abs(off) > eye_deg) known.offset_deg = std::clamp(known.offset_deg - off, -360.0, 360.0);
  }
  if (ports[0] == ports[1]) return no_encoders(HaplyWiringProblem::same_twice);
  return found;
}

HaplyMotors find_haply_motors(const std::array<HaplyPulse, 2>& pulses, const HaplyCalibration& assumed) noexcept {
  constexpr double least_move_deg = 0.4;
  HaplyMotors found{HaplyWiringProblem::none, assumed};
  std::array<std::size_t, 2> moved{};
  for (std::size_t motor = 0; motor < 2; ++motor) {
    const Vector<2>& by = pulses[motor].moved_deg;
    moved[motor] = std::abs(by.y) > std::abs(by.x) ? 1 : 0;
    const double way = by[static_cast<glm::length_t>(moved[motor])];
    if (std::abs(way) < least_move_deg) return {HaplyWiringProblem::no_movement, assumed};
    const HaplyArm& told = assumed.arms[motor];
    HaplyArm& known = found.calibration.arms[moved[motor]];
    known.motor_port = told.motor_port;
    known.motor_direction = told.motor_direction;
    known.is_motor_reversed = (way * pulses[motor].torque < 0.0) != told.is_motor_reversed;
  }
  if (moved[0] == moved[1]) return {HaplyWiringProblem::same_twice, assumed};
  return found;
}

std::optional<Vector<2>> find_torque_scales(const HaplyHold& without, const HaplyHold& with_weight,
                                            double weight) noexcept {
  const std::array<double, 2> needed = torques_for(with_weight.pose, {0.0, -weight});
  Vector<2> scales;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const auto i = static_cast<glm::length_t>(arm);
    const double inwards = (with_weight.inwards[i] - without.inwards[i]) / needed[arm];
    const double outwards = (with_weight.outwards[i] - without.outwards[i]) / needed[arm];
    if (!(inwards > 0.0 && outwards > 0.0)) return std::nullopt;
    scales[i] = 1.0 / std::sqrt(inwards * outwards);
    if (!(scales[i] >= 0.1 && scales[i] <= 10.0)) return std::nullopt;
  }
  return scales;
}

bool SwingCounter::add(double time_s, double speed) noexcept {
  if (std::abs(speed) < least_speed) return false;
  const int way = speed > 0.0 ? 1 : -1;
  if (std::exchange(way_, way) == way) return false;
  turns_s_[count_++ % enough] = time_s;
  return count_ >= enough && time_s - turns_s_[count_ % enough] <= within_s;
}

}  // namespace ghostforce
