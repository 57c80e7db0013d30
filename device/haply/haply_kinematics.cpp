#include "device/haply/haply_kinematics.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

// Sines below this are those of parallel links: neither the handle's place nor its forces can be told.
constexpr double parallel = 1e-6;

Vector<2> along(double angle) noexcept {
  return {std::cos(angle), std::sin(angle)};
}

// The z of a × b.
double cross(const Vector<2>& a, const Vector<2>& b) noexcept {
  return a.x * b.y - a.y * b.x;
}

double determinant(const Matrix<2>& matrix) noexcept {
  return matrix[0].x * matrix[1].y - matrix[1].x * matrix[0].y;
}

}  // namespace

std::optional<PantographPose> pose_at(const PantographGeometry& geometry,
                                      const std::array<double, 2>& angles) noexcept {
  PantographPose pose;
  const std::array<Vector<2>, 2> driven{along(angles[0]), along(angles[1])};
  pose.elbows = {geometry.driven_length * driven[0],
                 Vector<2>(geometry.base, 0.0) + geometry.driven_length * driven[1]};
  const Vector<2> between = pose.elbows[1] - pose.elbows[0];
  const double distance = glm::length(between);
  const double rise_squared = geometry.distal_length * geometry.distal_length - 0.25 * distance * distance;
  // With the second elbow beyond the first one, the arms would have passed through each other.
  const bool are_apart = between.x > 0.0 && distance > parallel * geometry.distal_length;
  if (!are_apart || !(rise_squared > 0.0)) return std::nullopt;
  const Vector<2> across = Vector<2>(-between.y, between.x) / distance;
  pose.handle = pose.elbows[0] + 0.5 * between + std::sqrt(rise_squared) * across;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    pose.directions[arm] = (pose.handle - pose.elbows[arm]) / geometry.distal_length;
  }
  const double between_links = cross(pose.directions[0], pose.directions[1]);
  if (!(std::abs(between_links) > parallel)) return std::nullopt;
  for (std::size_t arm = 0; arm < 2; ++arm) {
    // The other distal link keeps its length: the handle moves across it, and along this one as its elbow pushes.
    const Vector<2> elbow_moves = geometry.driven_length * Vector<2>(-driven[arm].y, driven[arm].x);
    const Vector<2>& other = pose.directions[1 - arm];
    const double sign = arm == 0 ? 1.0 : -1.0;
    pose.jacobian[static_cast<glm::length_t>(arm)] =
        sign * glm::dot(pose.directions[arm], elbow_moves) / between_links * Vector<2>(other.y, -other.x);
  }
  return pose;
}

std::optional<std::array<double, 2>> angles_at(const PantographGeometry& geometry, const Vector<2>& handle) noexcept {
  std::array<double, 2> angles{};
  for (std::size_t arm = 0; arm < 2; ++arm) {
    const Vector<2> from_motor = handle - Vector<2>(arm == 0 ? 0.0 : geometry.base, 0.0);
    const double distance = glm::length(from_motor);
    const double l = geometry.driven_length;
    const double cosine =
        (l * l + distance * distance - geometry.distal_length * geometry.distal_length) / (2.0 * l * distance);
    if (!(std::abs(cosine) <= 1.0)) return std::nullopt;
    const double bend = std::acos(cosine);
    angles[arm] = std::atan2(from_motor.y, from_motor.x) + (arm == 0 ? bend : -bend);
  }
  return angles;
}

double margin_of(const PantographPose& pose, const std::array<double, 2>& angles) noexcept {
  double margin = std::abs(cross(pose.directions[0], pose.directions[1]));
  for (std::size_t arm = 0; arm < 2; ++arm) {
    margin = std::min(margin, std::abs(cross(along(angles[arm]), pose.directions[arm])));
  }
  return margin;
}

Vector<2> nearest_within_reach(const PantographGeometry& geometry, const Vector<2>& center,
                               const Vector<2>& goal) noexcept {
  constexpr double least_margin = 0.3;
  constexpr int halvings = 20;
  const auto is_within = [&](double share) {
    const auto angles = angles_at(geometry, glm::mix(center, goal, share));
    const auto pose = angles ? pose_at(geometry, *angles) : std::nullopt;
    return pose && margin_of(*pose, *angles) >= least_margin;
  };
  // From the middle on: beyond a place that is out of reach there may be another one that is not, round the other way.
  constexpr int steps = 64;
  double within = 0.0;
  double beyond = 1.0;
  bool is_all_within = true;
  for (int i = 1; i <= steps && is_all_within; ++i) {
    const double share = static_cast<double>(i) / steps;
    is_all_within = is_within(share);
    (is_all_within ? within : beyond) = share;
  }
  if (is_all_within) return goal;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (within + beyond);
    (is_within(middle) ? within : beyond) = middle;
  }
  return glm::mix(center, goal, within);
}

std::array<double, 2> torques_for(const PantographPose& pose, const Vector<2>& force) noexcept {
  return {glm::dot(pose.jacobian[0], force), glm::dot(pose.jacobian[1], force)};
}

std::optional<Vector<2>> force_of(const PantographPose& pose, const std::array<double, 2>& torques) noexcept {
  const double area = determinant(pose.jacobian);
  const double size = glm::length(pose.jacobian[0]) * glm::length(pose.jacobian[1]);
  if (!(std::abs(area) > parallel * size)) return std::nullopt;
  const Vector<2>& first = pose.jacobian[0];
  const Vector<2>& second = pose.jacobian[1];
  return Vector<2>(torques[0] * second.y - torques[1] * first.y, torques[1] * first.x - torques[0] * second.x) / area;
}

Vector<2> line_of_motor(const PantographPose& pose, std::size_t arm) noexcept {
  return pose.directions[arm];
}

double lever_of_motor(const PantographPose& pose, std::size_t arm) noexcept {
  return std::abs(glm::dot(line_of_motor(pose, arm), pose.jacobian[static_cast<glm::length_t>(arm)]));
}

double condition_of(const PantographPose& pose) noexcept {
  const double squares = glm::dot(pose.jacobian[0], pose.jacobian[0]) + glm::dot(pose.jacobian[1], pose.jacobian[1]);
  const double area = std::abs(determinant(pose.jacobian));
  const double root = std::sqrt(std::max(0.0, squares * squares - 4.0 * area * area));
  const double smallest = squares - root;
  return smallest > 0.0 ? std::sqrt((squares + root) / smallest) : std::numeric_limits<double>::infinity();
}

}  // namespace ghostforce
