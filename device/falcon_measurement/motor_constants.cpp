#include "device/falcon_measurement/motor_constants.h"

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

}  // namespace ghostforce
