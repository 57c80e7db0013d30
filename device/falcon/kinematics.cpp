#include "device/falcon/kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace ghostforce {
namespace {

// A step of the search. Longer ones overshoot to where no leg reaches.
constexpr double longest_step = 0.030;  // [m]
// Of a gap. Far above rounding (1e-16 m); as an angle at most 1e-10 rad where a leg is bent by more than 1°, while an
// encoder's count is 6e-4 rad.
constexpr double gap_tolerance = 1e-13;  // [m]
// From the cold start 8 suffice wherever a handle can be.
constexpr int most_iterations = 15;
// 2⁻²⁰ of a step moves nothing that matters.
constexpr int most_halvings = 20;
// A parallelepiped of three unit vectors that is flatter than this has no inverse worth having.
constexpr double least_volume = 1e-9;

bool is_finite(const Vector<3>& v) noexcept {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double greatest(const Vector<3>& v) noexcept {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double triple_product(const Vector<3>& a, const Vector<3>& b, const Vector<3>& c) noexcept {
  return glm::dot(a, glm::cross(b, c));
}

// From a leg's own axes, radial, tangential and z, to everybody's.
Vector<3> turned(double cosine, double sine, double radial, double tangential, double z) noexcept {
  return {cosine * radial - sine * tangential, sine * radial + cosine * tangential, z};
}

// Row i of a matrix whose columns glm stores.
Vector<3> row(const Matrix<3>& matrix, glm::length_t i) noexcept {
  return {matrix[0][i], matrix[1][i], matrix[2][i]};
}

}  // namespace

FalconKinematics::FalconKinematics(const FalconGeometry& geometry) noexcept : geometry_(geometry), azimuths_{} {
  for (std::size_t i = 0; i < azimuths_.size(); ++i) {
    azimuths_[i] = {std::cos(geometry.azimuths[i]), std::sin(geometry.azimuths[i])};
  }
  if (Legs legs; solve(cold_start, legs)) {
    handedness_ = std::copysign(1.0, triple_product(legs[0].direction, legs[1].direction, legs[2].direction));
  }
}

bool FalconKinematics::reach(const Vector<3>& position, const Azimuth& azimuth, Reach& reach) const noexcept {
  const FalconGeometry& g = geometry_;
  const double tangential =
      azimuth.cosine * position.y - azimuth.sine * position.x - g.base_tangential + g.effector_tangential;
  reach.radial = azimuth.cosine * position.x + azimuth.sine * position.y - g.base_radial + g.effector_radial;
  reach.lean_cosine = tangential / g.parallelogram;
  // Written so that NaN is out of reach too.
  if (!(std::abs(reach.lean_cosine) < 1.0)) return false;
  reach.lean_sine = std::sqrt(1.0 - reach.lean_cosine * reach.lean_cosine);
  reach.length = g.near_link + g.far_link + g.parallelogram * reach.lean_sine;
  return true;
}

// Upper arm, parallelogram and the line from the motor to the leg's end are a triangle in the plane in which the arm
// swings. Sines and cosines come from its sides, so that one arc tangent is all it takes.
bool FalconKinematics::solve(const Vector<3>& position, Legs& legs) const noexcept {
  const double arm = geometry_.upper_arm;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    Reach r;
    if (!reach(position, azimuths_[i], r)) return false;
    const double squared_distance = r.radial * r.radial + position.z * position.z;
    const double distance = std::sqrt(squared_distance);
    const double corner_cosine = (squared_distance + arm * arm - r.length * r.length) / (2.0 * arm * distance);
    if (!(std::abs(corner_cosine) <= 1.0)) return false;
    const double corner_sine = std::sqrt(1.0 - corner_cosine * corner_cosine);

    // The knee is on the outer side: the arm's angle is that of the line less the corner.
    const double arm_cosine = (r.radial * corner_cosine + position.z * corner_sine) / distance;
    const double arm_sine = (position.z * corner_cosine - r.radial * corner_sine) / distance;
    const double rod_cosine = (r.radial - arm * arm_cosine) / r.length;
    const double rod_sine = (position.z - arm * arm_sine) / r.length;

    legs[i].angle = std::atan2(arm_sine, arm_cosine);
    legs[i].direction =
        turned(azimuths_[i].cosine, azimuths_[i].sine, rod_cosine * r.lean_sine, r.lean_cosine, rod_sine * r.lean_sine);
    legs[i].lever = arm * r.lean_sine * (rod_sine * arm_cosine - rod_cosine * arm_sine);
  }
  return true;
}

std::optional<Vector<3>> FalconKinematics::angles(const Vector<3>& position) const noexcept {
  Legs legs;
  if (!solve(position, legs)) return std::nullopt;
  return Vector<3>(legs[0].angle, legs[1].angle, legs[2].angle);
}

std::optional<Matrix<3>> FalconKinematics::jacobian(const Vector<3>& position) const noexcept {
  Legs legs;
  if (!solve(position, legs)) return std::nullopt;
  std::array<Vector<3>, 3> rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i] = legs[i].direction / legs[i].lever;
    if (!is_finite(rows[i])) return std::nullopt;
  }
  return glm::transpose(Matrix<3>(rows[0], rows[1], rows[2]));
}

ForwardKinematics FalconKinematics::position(const Vector<3>& angles, const Vector<3>& start) const noexcept {
  if (!is_finite(angles)) return {.position = start};
  const Arms arms{glm::cos(angles), glm::sin(angles)};
  const ForwardKinematics warm = search(arms, start);
  if (warm.has_converged || start == cold_start) return warm;
  ForwardKinematics cold = search(arms, cold_start);
  cold.iterations += warm.iterations;
  return cold;
}

bool FalconKinematics::measure(const Vector<3>& position, const Arms& arms, Gaps& gaps) const noexcept {
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    Reach r;
    if (!reach(position, azimuths_[i], r)) return false;
    const auto axis = static_cast<glm::length_t>(i);
    const double radial = r.radial - geometry_.upper_arm * arms.cosines[axis];
    const double z = position.z - geometry_.upper_arm * arms.sines[axis];
    const double length = std::sqrt(radial * radial + z * z);
    if (!(length > 0.0)) return false;
    const double rod_cosine = radial / length;
    const double rod_sine = z / length;
    gaps[i].size = (length - r.length) * r.lean_sine;
    gaps[i].gradient =
        turned(azimuths_[i].cosine, azimuths_[i].sine, rod_cosine * r.lean_sine, r.lean_cosine, rod_sine * r.lean_sine);
    gaps[i].bend = rod_sine * arms.cosines[axis] - rod_cosine * arms.sines[axis];
  }
  return true;
}

// Newton's method on the gaps of the three legs. On the angles' differences it would be the same near the solution, but
// those do not exist beyond a leg's reach, where a long step may well lead on its way; a gap can be measured there.
ForwardKinematics FalconKinematics::search(const Arms& arms, const Vector<3>& start) const noexcept {
  ForwardKinematics found{.position = start};
  Gaps gaps;
  if (!measure(start, arms, gaps)) return found;
  for (;;) {
    const Vector<3> sizes(gaps[0].size, gaps[1].size, gaps[2].size);
    const double volume = triple_product(gaps[0].gradient, gaps[1].gradient, gaps[2].gradient);
    if (greatest(sizes) < gap_tolerance) {
      found.has_converged =
          volume * handedness_ > 0.0 && gaps[0].bend >= 0.0 && gaps[1].bend >= 0.0 && gaps[2].bend >= 0.0;
      return found;
    }
    if (found.iterations == most_iterations || !(std::abs(volume) > least_volume)) return found;
    ++found.iterations;
    // By Cramer's rule.
    Vector<3> step = (sizes[0] * glm::cross(gaps[1].gradient, gaps[2].gradient) +
                      sizes[1] * glm::cross(gaps[2].gradient, gaps[0].gradient) +
                      sizes[2] * glm::cross(gaps[0].gradient, gaps[1].gradient)) /
                     -volume;
    const double length = glm::length(step);
    if (length > longest_step) step *= longest_step / length;

    bool is_better = false;
    for (int halvings = 0; !is_better && halvings <= most_halvings; ++halvings, step *= 0.5) {
      Gaps there;
      if (!measure(found.position + step, arms, there)) continue;
      if (!(greatest({there[0].size, there[1].size, there[2].size}) < greatest(sizes))) continue;
      is_better = true;
      found.position += step;
      gaps = there;
    }
    if (!is_better) return found;
  }
}

std::optional<Vector<3>> joint_torques(const Vector<3>& force, const Matrix<3>& jacobian) noexcept {
  // Aᵀτ = F by Cramer's rule: the rows of A are the columns of Aᵀ.
  const Vector<3> a = row(jacobian, 0);
  const Vector<3> b = row(jacobian, 1);
  const Vector<3> c = row(jacobian, 2);
  const Vector<3> bc = glm::cross(b, c);
  const double volume = glm::dot(a, bc);
  // Written so that NaN is singular too.
  if (!(std::abs(volume) > least_volume * glm::length(a) * glm::length(b) * glm::length(c))) return std::nullopt;
  const Vector<3> torques =
      Vector<3>(glm::dot(bc, force), glm::dot(glm::cross(c, a), force), glm::dot(glm::cross(a, b), force)) / volume;
  if (!is_finite(torques)) return std::nullopt;
  return torques;
}

MotorCommand motor_counts(const Vector<3>& force, const Matrix<3>& jacobian, double counts_per_newton_metre) noexcept {
  const std::optional<Vector<3>> torques = joint_torques(force, jacobian);
  if (!torques) return {};
  Vector<3> counts = -counts_per_newton_metre * *torques;
  if (!is_finite(counts)) return {};
  MotorCommand command{.is_valid = true};
  if (const double most = greatest(counts); most > most_motor_counts) {
    command.is_saturated = true;
    counts *= most_motor_counts / most;
  }
  for (std::size_t i = 0; i < command.counts.size(); ++i) {
    command.counts[i] = static_cast<std::int16_t>(std::lround(counts[static_cast<glm::length_t>(i)]));
  }
  return command;
}

Vector<3> force_of_motor_counts(const MotorNumbers& counts, const Matrix<3>& jacobian,
                                double counts_per_newton_metre) noexcept {
  const Vector<3> torques = -Vector<3>(counts[0], counts[1], counts[2]) / counts_per_newton_metre;
  return torques * jacobian;  // a row times A: Aᵀτ
}

}  // namespace ghostforce
