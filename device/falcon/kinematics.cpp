#include "device/falcon/kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ghostforce {
namespace {

// A step of the search. Longer ones overshoot to where no leg reaches.
constexpr double longest_step = 0.030;  // [m]
// Of a gap. Far above rounding (1e-16 m); as an angle at most 1e-10 rad where a leg is bent by more than 1°, while an
// encoder's count is 6e-4 rad.
constexpr double gap_tolerance = 1e-13;  // [m]
// A step so short leaves gaps below that tolerance: they bend by less than 10 per metre, so that what a step leaves is
// less than five times its square. Nobody has to look again.
constexpr double last_step = 1e-7;  // [m]
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
  if (const std::optional<Matrix<3>> there = jacobian(cold_start)) {
    // Its rows are the parallelograms' directions, each divided by a positive length.
    handedness_ = std::copysign(1.0, glm::determinant(*there));
  }
}

FalconKinematics::Leg FalconKinematics::leg_ending_at(const Vector<3>& position,
                                                      const Azimuth& azimuth) const noexcept {
  const FalconGeometry& g = geometry_;
  Leg leg;
  leg.radial = azimuth.cosine * position.x + azimuth.sine * position.y - g.base_radial + g.effector_radial;
  leg.tangential = azimuth.cosine * position.y - azimuth.sine * position.x - g.base_tangential + g.effector_tangential;
  leg.height = std::sqrt(g.parallelogram * g.parallelogram - leg.tangential * leg.tangential);
  leg.length = g.near_link + g.far_link + leg.height;
  const double squared_arm = g.upper_arm * g.upper_arm;
  const double squared_line = leg.radial * leg.radial + position.z * position.z;
  leg.cosine = squared_line + squared_arm - leg.length * leg.length;
  leg.sine = std::sqrt(4.0 * squared_arm * squared_line - leg.cosine * leg.cosine);
  return leg;  // out of reach: some of it is NaN, and so is the sine
}

// The knee is on the outer side: the arm's angle is that of the line less the corner. The difference's sine and cosine
// come from the triangle's sides, times a product of them that needs no root; the arc tangent of half the angle costs
// half of that with two arguments.
std::optional<Vector<3>> FalconKinematics::angles(const Vector<3>& position) const noexcept {
  Vector<3> angles;
  for (std::size_t i = 0; i < azimuths_.size(); ++i) {
    const Leg leg = leg_ending_at(position, azimuths_[i]);
    if (!std::isfinite(leg.sine)) return std::nullopt;
    const double sine = position.z * leg.cosine - leg.radial * leg.sine;
    const double cosine = leg.radial * leg.cosine + position.z * leg.sine;
    const double unit = 2.0 * geometry_.upper_arm * (leg.radial * leg.radial + position.z * position.z);
    // Of two forms, the one that takes no difference of near numbers.
    const double half_tangent = cosine >= 0.0 ? sine / (unit + cosine) : (unit - cosine) / sine;
    angles[static_cast<glm::length_t>(i)] = 2.0 * std::atan(half_tangent);
  }
  return angles;
}

// A row is the direction of the parallelogram's long side over its lever about the motor's axis; both are written with
// what they have in common cancelled.
std::optional<Matrix<3>> FalconKinematics::jacobian(const Vector<3>& position) const noexcept {
  std::array<Vector<3>, 3> rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Leg leg = leg_ending_at(position, azimuths_[i]);
    // From the arm's end to the leg's end, times twice the line squared; the arm's end is where angles() says.
    const double twice_line = 2.0 * (leg.radial * leg.radial + position.z * position.z);
    const double rod_radial = leg.radial * (twice_line - leg.cosine) - position.z * leg.sine;
    const double rod_z = position.z * (twice_line - leg.cosine) + leg.radial * leg.sine;
    const double scale = 2.0 / (twice_line * leg.height * leg.sine);
    rows[i] = turned(azimuths_[i].cosine, azimuths_[i].sine, scale * leg.height * rod_radial,
                     scale * twice_line * leg.length * leg.tangential, scale * leg.height * rod_z);
    if (!is_finite(rows[i])) return std::nullopt;
  }
  return glm::transpose(Matrix<3>(rows[0], rows[1], rows[2]));
}

ForwardKinematics FalconKinematics::position(const Vector<3>& angles, const Vector<3>& start) const noexcept {
  if (!is_finite(angles)) return {.position = start};
  const Arms arms{{std::cos(angles.x), std::cos(angles.y), std::cos(angles.z)},
                  {std::sin(angles.x), std::sin(angles.y), std::sin(angles.z)}};
  const ForwardKinematics warm = search(arms, start);
  if (warm.has_converged || start == cold_start) return warm;
  ForwardKinematics cold = search(arms, cold_start);
  cold.iterations += warm.iterations;
  return cold;
}

// The parallelogram's long side reaches from the knee, past the short sides, to the leg's end. Its length enters
// squared: that costs one root and one division per leg, and exists wherever a long step may lead.
bool FalconKinematics::measure(const Vector<3>& position, const Arms& arms, Gaps& gaps) const noexcept {
  const FalconGeometry& g = geometry_;
  const double links = g.near_link + g.far_link;
  const double per_parallelogram = 1.0 / g.parallelogram;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const auto axis = static_cast<glm::length_t>(i);
    const Azimuth& azimuth = azimuths_[i];
    const double tangential =
        azimuth.cosine * position.y - azimuth.sine * position.x - g.base_tangential + g.effector_tangential;
    const double radial = azimuth.cosine * position.x + azimuth.sine * position.y - g.base_radial + g.effector_radial -
                          g.upper_arm * arms.cosines[axis];
    const double z = position.z - g.upper_arm * arms.sines[axis];
    const double length = std::sqrt(radial * radial + z * z);
    const double height = length - links;
    const double share = height / length * per_parallelogram;
    gaps[i].size =
        0.5 * per_parallelogram * (height * height + tangential * tangential - g.parallelogram * g.parallelogram);
    // Not finite, or the end in the knee.
    if (!std::isfinite(gaps[i].size) || !std::isfinite(share)) return false;
    gaps[i].gradient = turned(azimuth.cosine, azimuth.sine, radial * share, tangential * per_parallelogram, z * share);
    gaps[i].is_bent_right = height >= 0.0 && z * arms.cosines[axis] >= radial * arms.sines[axis];
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
    const auto is_right_way_round = [&] {
      return volume * handedness_ > 0.0 && gaps[0].is_bent_right && gaps[1].is_bent_right && gaps[2].is_bent_right;
    };
    if (greatest(sizes) < gap_tolerance) {
      found.has_converged = is_right_way_round();
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
    if (length < last_step) {
      found.position += step;
      found.has_converged = is_right_way_round();
      return found;
    }

    const double before = greatest(sizes);
    bool is_better = false;
    for (int halvings = 0; !is_better && halvings <= most_halvings; ++halvings, step *= 0.5) {
      if (!measure(found.position + step, arms, gaps)) continue;
      if (!(greatest({gaps[0].size, gaps[1].size, gaps[2].size}) < before)) continue;
      is_better = true;
      found.position += step;
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
  const double squared_lengths = glm::dot(a, a) * glm::dot(b, b) * glm::dot(c, c);
  if (!(volume * volume > least_volume * least_volume * squared_lengths)) return std::nullopt;
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
    command.counts[i] = static_cast<std::int16_t>(std::lrint(counts[static_cast<glm::length_t>(i)]));
  }
  return command;
}

Vector<3> force_of_motor_counts(const MotorNumbers& counts, const Matrix<3>& jacobian,
                                double counts_per_newton_metre) noexcept {
  const Vector<3> torques = -Vector<3>(counts[0], counts[1], counts[2]) / counts_per_newton_metre;
  return torques * jacobian;  // a row times A: Aᵀτ
}

}  // namespace ghostforce
