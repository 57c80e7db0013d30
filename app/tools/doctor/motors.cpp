#include "app/tools/doctor/motors.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ghostforce {
namespace {

// One standard deviation of a component of the force, however well all fits: a weight swings, a finger does not stay
// the same.
constexpr double least_deviation = 0.008;  // [N]
// What fits worse by so much of the weight is no weight that hung still.
constexpr double worst_share = 0.1;

// The force at the handle by each leg's motor, per unit of its torque per count: columns.
Matrix<3> force_per_torque(const Matrix<3>& jacobian, const Vector<3>& counts) noexcept {
  Matrix<3> columns;
  for (glm::length_t leg = 0; leg < 3; ++leg) {
    Vector<3> alone(0.0);
    alone[leg] = -counts[leg];
    columns[leg] = alone * jacobian;
  }
  return columns;
}

}  // namespace

MotorConstants find_motor_constants(std::span<const WeightReading> readings) noexcept {
  MotorConstants found;
  if (readings.empty()) return found;
  // By least squares: the torque per count of each motor, and of all alike.
  Matrix<3> normal(0.0);
  Vector<3> right(0.0);
  double common_normal = 0.0;
  double common_right = 0.0;
  double most_weight = 0.0;
  for (const WeightReading& reading : readings) {
    const Matrix<3> columns = force_per_torque(reading.jacobian, reading.with_weight.mean() - reading.without.mean());
    const Vector<3> lifted(0.0, reading.weight, 0.0);
    normal += glm::transpose(columns) * columns;
    right += lifted * columns;
    const Vector<3> together = columns * Vector<3>(1.0);
    common_normal += glm::dot(together, together);
    common_right += glm::dot(together, lifted);
    most_weight = std::max(most_weight, reading.weight);
  }
  if (!(glm::determinant(normal) > 0.0) || !(common_normal > 0.0) || !(common_right > 0.0)) return found;
  const Matrix<3> covariance = glm::inverse(normal);
  const Vector<3> each = covariance * right;
  const double common = common_right / common_normal;
  if (!(std::min({each.x, each.y, each.z}) > 0.0)) return found;

  const auto squares_of = [&](const Vector<3>& torque_per_count) {
    double squares = 0.0;
    for (const WeightReading& reading : readings) {
      const Vector<3> counts = reading.with_weight.mean() - reading.without.mean();
      const Vector<3> off =
          force_per_torque(reading.jacobian, counts) * torque_per_count - Vector<3>(0.0, reading.weight, 0.0);
      squares += glm::dot(off, off);
    }
    return squares;
  };
  const double equations = 3.0 * static_cast<double>(readings.size());
  const double deviation = std::max(least_deviation, std::sqrt(squares_of(each) / std::max(equations - 3.0, 1.0)));

  const double strongest = std::max({each.x, each.y, each.z});
  found.are_alike = true;
  for (glm::length_t leg = 0; leg < 3; ++leg) {
    const double uncertainty = 2.0 * deviation * std::sqrt(covariance[leg][leg]);
    found.strengths[leg] = each[leg] / strongest;
    found.strength_uncertainties[leg] = uncertainty / strongest;
    if (std::abs(each[leg] - common) > uncertainty) found.are_alike = false;
  }
  double torque_per_count = strongest;
  double relative = 0.0;
  if (found.are_alike) {
    torque_per_count = common;
    relative = 2.0 * deviation / std::sqrt(common_normal) / common;
    found.strengths = Vector<3>(1.0);
  } else {
    for (glm::length_t leg = 0; leg < 3; ++leg) {
      if (each[leg] == strongest) relative = found.strength_uncertainties[leg];
    }
  }
  found.counts_per_newton_metre = 1.0 / torque_per_count;
  found.uncertainty = relative / torque_per_count;
  const Vector<3> used = torque_per_count * found.strengths;
  found.misfit = std::sqrt(squares_of(used) / equations);
  found.is_found = found.misfit <= worst_share * most_weight;

  const double share = 1.0 / static_cast<double>(readings.size());
  for (const WeightReading& reading : readings) {
    const HoldReading& hold = reading.without;
    const Vector<3> rub = force_per_torque(reading.jacobian, 0.5 * (hold.up - hold.down)) * used;
    found.friction += share * std::abs(rub.y);
    found.handle_weight += share * (force_per_torque(reading.jacobian, hold.mean()) * used).y;
  }
  return found;
}

bool MotorPulse::has_moved() const noexcept {
  return std::max({std::abs(moved.x), std::abs(moved.y), std::abs(moved.z)}) >= least_move;
}

MotorWiring find_motor_wiring(const std::array<MotorPulse, 3>& pulses) noexcept {
  MotorWiring wiring;
  wiring.motor_of_leg = {};
  for (std::size_t number = 0; number < pulses.size(); ++number) {
    const MotorPulse& pulse = pulses[number];
    if (!pulse.has_moved()) return {.problem = MotorProblem::no_movement};
    glm::length_t leg = 0;
    for (glm::length_t i = 1; i < 3; ++i) {
      if (std::abs(pulse.moved[i]) > std::abs(pulse.moved[leg])) leg = i;
    }
    std::int8_t& of_leg = wiring.motor_of_leg[static_cast<std::size_t>(leg)];
    if (of_leg != 0) return {.problem = MotorProblem::same_leg_twice};
    // Above 0 pulls in, where the leg's counts shrink.
    const bool pulls_in = pulse.moved[leg] * pulse.counts < 0.0;
    const int counted = static_cast<int>(number) + 1;
    of_leg = static_cast<std::int8_t>(pulls_in ? counted : -counted);
  }
  return wiring;
}

namespace {

// Less than this cannot be told from a hand that moves by itself [m].
constexpr double least_held = 0.0008;
constexpr double most_tremor_share = 0.3;
// Of the displacement: above the one the force was there, below the other it was gone; in between the handle is on its
// way back.
constexpr double there_share = 0.75;
constexpr double gone_share = 0.3;

bool is_readable(const SilenceReading& reading) noexcept {
  return reading.held >= least_held && reading.tremor <= most_tremor_share * reading.held;
}
bool was_there(const SilenceReading& reading) noexcept {
  return is_readable(reading) && reading.after >= there_share * reading.held;
}
bool was_gone(const SilenceReading& reading) noexcept {
  return is_readable(reading) && reading.after <= gone_share * reading.held;
}

}  // namespace

SilenceVerdict judge_silences(std::span<const SilenceReading> readings) noexcept {
  SilenceVerdict verdict;
  double longest = 0.0;
  bool has_gone = false;
  for (const SilenceReading& reading : readings) {
    longest = std::max(longest, reading.silence_s);
    if (was_there(reading)) verdict.still_there_s = std::max(verdict.still_there_s, reading.silence_s);
    if (was_gone(reading)) {
      verdict.gone_s = has_gone ? std::min(verdict.gone_s, reading.silence_s) : reading.silence_s;
      has_gone = true;
    }
  }
  if (has_gone && verdict.still_there_s < verdict.gone_s) {
    verdict.outcome = SilenceOutcome::drops;
  } else if (!has_gone && longest > 0.0 && verdict.still_there_s == longest) {
    verdict.outcome = SilenceOutcome::stays;
  }
  return verdict;
}

}  // namespace ghostforce
