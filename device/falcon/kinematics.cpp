#include "device/falcon/kinematics.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ghostforce {
namespace {

// A step of the search. Longer ones overshoot to where no leg reaches.
constexpr double longest_step = 0.030;  // [m]
// Of a gap. Far above rounding (1e-16 m); as an angle at most 1e-10 rad where a leg is bent by more than 1°, while an
// encoder's count is 6e-4 rad.
constexpr double gap_tolerance = 1e-13;  // [m]
// A step so short leaves gaps of about that tolerance: they bend by less than 10 per metre, so that what a step leaves
// is less than five times its square. Nobody has to look again.
constexpr double last_step = 3e-7;  // [m]
// Steps up to here allow for how the gaps bend on their way: they leave the cube of their length instead of its square.
constexpr double bent_step = 0.005;  // [m]
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

// Flattened: the search is called here only, and what it measures stays in registers.
[[gnu::flatten]] ForwardKinematics FalconKinematics::position(const Vector<3>& angles,
                                                              const Vector<3>& start) const noexcept {
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
// squared: that costs one root per leg and no division, and exists wherever a long step may lead.
bool FalconKinematics::measure(const Vector<3>& position, const Arms& arms, Gaps& gaps) const noexcept {
  const FalconGeometry& g = geometry_;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const auto axis = static_cast<glm::length_t>(i);
    const Azimuth& azimuth = azimuths_[i];
    Gap& gap = gaps[i];
    const double knee_radial = g.base_radial - g.effector_radial + g.upper_arm * arms.cosines[axis];
    gap.radial = azimuth.cosine * position.x + azimuth.sine * position.y - knee_radial;
    const double tangential =
        azimuth.cosine * position.y - azimuth.sine * position.x - (g.base_tangential - g.effector_tangential);
    gap.z = position.z - g.upper_arm * arms.sines[axis];
    gap.length = std::sqrt(gap.radial * gap.radial + gap.z * gap.z);
    gap.height = gap.length - (g.near_link + g.far_link);
    gap.size = 0.5 * (gap.height * gap.height + tangential * tangential - g.parallelogram * g.parallelogram);
    // Not finite, or the end in the knee.
    if (!std::isfinite(gap.size) || !(gap.length > 0.0)) return false;
    gap.gradient =
        turned(azimuth.cosine, azimuth.sine, gap.radial * gap.height, tangential * gap.length, gap.z * gap.height);
    gap.is_bent_right = gap.height >= 0.0 && gap.z * arms.cosines[axis] >= gap.radial * arms.sines[axis];
  }
  return true;
}

// What the gaps grow by on a step beyond what their gradients say, to second order, times `length` [m³].
Vector<3> FalconKinematics::bends(const Gaps& gaps, const Vector<3>& step) const noexcept {
  Vector<3> bends;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const Gap& gap = gaps[i];
    const Azimuth& azimuth = azimuths_[i];
    const double radial = azimuth.cosine * step.x + azimuth.sine * step.y;
    const double tangential = azimuth.cosine * step.y - azimuth.sine * step.x;
    const double along = (gap.radial * radial + gap.z * step.z) / gap.length;
    bends[static_cast<glm::length_t>(i)] =
        0.5 * (gap.height * (radial * radial + step.z * step.z) + (gap.length - gap.height) * along * along +
               gap.length * tangential * tangential);
  }
  return bends;
}

// Newton's method on the gaps of the three legs, and Chebyshev's for short steps. On the angles' differences it would
// be the same near the solution, but those do not exist beyond a leg's reach, where a long step may well lead on its
// way; a gap can be measured there.
ForwardKinematics FalconKinematics::search(const Arms& arms, const Vector<3>& start) const noexcept {
  ForwardKinematics found{.position = start};
  const double parallelogram = geometry_.parallelogram;
  const double cubed_parallelogram = parallelogram * parallelogram * parallelogram;
  Gaps gaps;
  if (!measure(start, arms, gaps)) return found;
  const auto greatest_gap = [&] { return greatest({gaps[0].size, gaps[1].size, gaps[2].size}); };
  for (;;) {
    // Each row of the equations is multiplied by its leg's length, which changes nothing of what solves them.
    const Vector<3> first = glm::cross(gaps[1].gradient, gaps[2].gradient);
    const Vector<3> second = glm::cross(gaps[2].gradient, gaps[0].gradient);
    const Vector<3> third = glm::cross(gaps[0].gradient, gaps[1].gradient);
    const double volume = glm::dot(gaps[0].gradient, first);
    const double lengths = gaps[0].length * gaps[1].length * gaps[2].length;
    const auto is_right_way_round = [&] {
      return volume * handedness_ > 0.0 && gaps[0].is_bent_right && gaps[1].is_bent_right && gaps[2].is_bent_right;
    };
    const double before = greatest_gap();
    if (before < gap_tolerance * parallelogram) {
      found.has_converged = is_right_way_round();
      return found;
    }
    if (found.iterations == most_iterations) return found;
    if (!(std::abs(volume) > least_volume * lengths * cubed_parallelogram)) return found;
    ++found.iterations;
    // By Cramer's rule.
    const double per_volume = 1.0 / volume;
    const auto solved = [&](double a, double b, double c) {
      return (a * first + b * second + c * third) * -per_volume;
    };
    Vector<3> step =
        solved(gaps[0].size * gaps[0].length, gaps[1].size * gaps[1].length, gaps[2].size * gaps[2].length);
    const double squared_length = glm::dot(step, step);
    if (squared_length < last_step * last_step) {
      found.position += step;
      found.has_converged = is_right_way_round();
      return found;
    }
    if (squared_length < bent_step * bent_step) {
      const Vector<3> bent = bends(gaps, step);
      step += solved(bent[0], bent[1], bent[2]);
    } else if (squared_length > longest_step * longest_step) {
      step *= longest_step / std::sqrt(squared_length);
    }

    bool is_better = false;
    for (int halvings = 0; !is_better && halvings <= most_halvings; ++halvings, step *= 0.5) {
      if (!measure(found.position + step, arms, gaps)) continue;
      if (!(greatest_gap() < before)) continue;
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

MotorCommand motor_counts(const Vector<3>& force, const Matrix<3>& jacobian,
                          const Vector<3>& counts_per_newton_metre) noexcept {
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

Vector<3> force_of_motor_counts(const Vector<3>& counts, const Matrix<3>& jacobian,
                                const Vector<3>& counts_per_newton_metre) noexcept {
  return (-counts / counts_per_newton_metre) * jacobian;  // a row times A: Aᵀτ
}

}  // namespace ghostforce
