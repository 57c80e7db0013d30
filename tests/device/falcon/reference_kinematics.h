// The Falcon's kinematics a second time, by other formulas: Stamper's half-angle form of the angles, and derivatives as
// differences of those. Slow; for comparison.
#pragma once

#include <cmath>
#include <optional>

#include "core/conventions.h"
#include "device/falcon/kinematics.h"
#include "tests/core/random_setting.h"

namespace ghostforce {

// With three motors that are alike.
inline MotorCommand motor_counts(const Vector<3>& force, const Matrix<3>& jacobian, double motor_constant) noexcept {
  return motor_counts(force, jacobian, Vector<3>(motor_constant));
}
inline Vector<3> force_of_motor_counts(const MotorNumbers& counts, const Matrix<3>& jacobian,
                                       double motor_constant) noexcept {
  return force_of_motor_counts(vector_of(counts), jacobian, Vector<3>(motor_constant));
}

inline std::optional<Vector<3>> reference_angles(const Vector<3>& p, const FalconGeometry& g) {
  Vector<3> angles;
  for (glm::length_t i = 0; i < 3; ++i) {
    const double phi = g.azimuths[static_cast<std::size_t>(i)];
    const double u = std::cos(phi) * p.x + std::sin(phi) * p.y - g.base_radial;
    const double v = -std::sin(phi) * p.x + std::cos(phi) * p.y - g.base_tangential;
    const double w = p.z;
    const double a = g.upper_arm;
    const double c = g.effector_radial;
    const double lean = std::acos((v + g.effector_tangential) / g.parallelogram);
    const double reach = g.near_link + g.far_link + g.parallelogram * std::sin(lean);
    const double k = w * w + u * u + 2.0 * c * u + a * a + c * c - reach * reach;
    const double l0 = k - 2.0 * a * u - 2.0 * a * c;
    const double l1 = -4.0 * a * w;
    const double l2 = k + 2.0 * a * u + 2.0 * a * c;
    angles[i] = 2.0 * std::atan((-l1 - std::sqrt(l1 * l1 - 4.0 * l0 * l2)) / (2.0 * l2));
    if (!std::isfinite(angles[i])) return std::nullopt;
  }
  return angles;
}

// Central differences over ±h and ±2h, weighted so that the error is of the order h⁴: at h = 20 µm and more than 3 mm
// from where a leg ends, 1e-8 of the result, as much as the rounding of the angles makes.
inline std::optional<Matrix<3>> reference_jacobian(const Vector<3>& p, const FalconGeometry& g) {
  constexpr double h = 20e-6;
  Matrix<3> jacobian;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    Vector<3> step(0.0);
    step[axis] = h;
    const auto far_below = reference_angles(p - 2.0 * step, g);
    const auto below = reference_angles(p - step, g);
    const auto above = reference_angles(p + step, g);
    const auto far_above = reference_angles(p + 2.0 * step, g);
    if (!far_below || !below || !above || !far_above) return std::nullopt;
    jacobian[axis] = (8.0 * (*above - *below) - (*far_above - *far_below)) / (12.0 * h);
  }
  return jacobian;
}

// Anywhere that a Falcon's handle can be: in the box that programs use, ±60 mm by ±60 mm by 75 to 175 mm, and with
// encoders within ±1600 counts, which none was seen to leave.
inline Vector<3> random_position(Random& random, const FalconGeometry& g) {
  for (;;) {
    const Vector<3> p(random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06), random.uniform(0.075, 0.175));
    const auto angles = reference_angles(p, FalconGeometry{});
    if (!angles || !reference_angles(p, g)) continue;
    const Vector<3> counts = counts_of_angles(*angles, FalconGeometry{});
    if (std::abs(counts.x) < 1600.0 && std::abs(counts.y) < 1600.0 && std::abs(counts.z) < 1600.0) return p;
  }
}

// Where people work: inside the advertised 100 mm, without the outermost end.
inline Vector<3> random_working_position(Random& random) {
  for (;;) {
    const Vector<3> p(random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), random.uniform(0.08, 0.16));
    if (std::hypot(p.x, p.y) <= 0.05) return p;
  }
}

}  // namespace ghostforce
