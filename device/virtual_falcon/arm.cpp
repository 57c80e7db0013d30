#include "device/virtual_falcon/arm.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace ghostforce {
namespace {

constexpr double standard_gravity = 9.80665;  // [m/s²]

// In the half plane of a distance from the axis and a z: the stops' outline, from axis to axis.
using Corner = Vector<2>;
constexpr std::array<Corner, 5> outline{
    Corner{0.0, SimulatedArm::nearest},
    Corner{SimulatedArm::radius, SimulatedArm::nearest},
    Corner{SimulatedArm::radius, SimulatedArm::narrows_from},
    Corner{SimulatedArm::radius_at_farthest, SimulatedArm::farthest},
    Corner{0.0, SimulatedArm::farthest},
};

bool is_inside(const Corner& point) noexcept {
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const Corner edge = outline[i] - outline[i - 1];
    const Corner to_point = point - outline[i - 1];
    if (edge.x * to_point.y - edge.y * to_point.x < 0.0) return false;
  }
  return true;
}

Corner nearest_on_outline(const Corner& point) noexcept {
  Corner nearest{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const Corner edge = outline[i] - outline[i - 1];
    const double along = std::clamp(glm::dot(point - outline[i - 1], edge) / glm::dot(edge, edge), 0.0, 1.0);
    const Corner candidate = outline[i - 1] + along * edge;
    const double distance = glm::length(point - candidate);
    if (distance >= least) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

// The point inside the stops that is nearest. The set is convex: no two points are farther apart afterwards, and that
// is why the stops take energy and never give any.
Vector<3> held_by_stops(const Vector<3>& position) noexcept {
  const double distance = std::hypot(position.x, position.y);
  const Corner point{distance, position.z};
  if (is_inside(point)) return position;
  const Corner held = nearest_on_outline(point);
  const double scale = distance > 0.0 ? held.x / distance : 0.0;
  return {scale * position.x, scale * position.y, held.y};
}

}  // namespace

SimulatedArm::SimulatedArm(const Options& options) noexcept : kinematics_(options.geometry), options_(options) {
  if (const auto angles = kinematics_.angles({0.0, 0.0, nearest})) {
    pushed_in_ = static_cast<int>(std::lround(counts_of_angles(*angles, options.geometry).x));
  }
  if (!move_to(held_by_stops(options.start))) move_to(cold_start);
}

void SimulatedArm::step(double duration, const MotorNumbers& motors, const Vector<3>& goal, double stiffness,
                        double load) noexcept {
  force_ = force_of_motor_counts(in_leg_order(vector_of(motors), options_.motor_of_leg), jacobian_,
                                 options_.counts_per_newton_metre / options_.motor_strengths);
  const double mass = options_.mass + load / standard_gravity;
  const Vector<3> down(0.0, -options_.weight - load, 0.0);
  Vector<3> momentum = mass * velocity_ + duration * (stiffness * (goal - position_) + force_ + down);
  // Friction takes what it can of the motion, and never more.
  const double most = glm::length(momentum);
  if (most > 0.0) momentum *= std::max(0.0, 1.0 - duration * options_.friction / most);
  const double inertia = mass + duration * options_.damping + duration * duration * stiffness;
  const Vector<3> before = position_;
  if (move_to(held_by_stops(before + duration / inertia * momentum))) {
    velocity_ = (position_ - before) / duration;
  } else {
    velocity_ = {};
  }
}

// False, and nothing is changed, where the legs do not reach: some geometries are tighter than the stops.
bool SimulatedArm::move_to(const Vector<3>& position) noexcept {
  const auto angles = kinematics_.angles(position);
  const auto jacobian = kinematics_.jacobian(position);
  if (!angles || !jacobian) return false;
  position_ = position;
  jacobian_ = *jacobian;
  const Vector<3> counts = counts_of_angles(*angles, options_.geometry);
  for (std::size_t leg = 0; leg < encoders_.size(); ++leg) {
    const std::int8_t number = options_.encoder_of_leg[leg];
    const int count = static_cast<int>(std::lround(counts[static_cast<glm::length_t>(leg)]));
    encoders_[place_in_frame(number)] = number > 0 ? count : 2 * pushed_in_ - count;
  }
  return true;
}

}  // namespace ghostforce
