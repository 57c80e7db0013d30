#include "device/virtual_haply/haply_arms.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ghostforce {
namespace {

// Of a person who holds the links where they are to be: no motor moves them by more than a degree or two.
constexpr double pose_stiffness = 5.0;  // [N·m/rad]
constexpr double pose_damping = 0.1;    // [N·m·s/rad]

// The distal links, as the share of being stretched out on one line at which they stop.
constexpr double most_stretched = 0.999;

// Within which of an end its edge is already kept to, so that what is bent about it is not passed.
constexpr double edge = 1e-6;

// Of the difference of two energies: less would stop what creeps [J].
constexpr double rounding = 1e-15;

double least_of(const std::array<double, HaplyArms::ends>& room) noexcept {
  return *std::ranges::min_element(room);
}

Matrix<2> diagonal(const Vector<2>& values) noexcept {
  return Matrix<2>{values.x, 0.0, 0.0, values.y};
}

// The x with the least ½ xᵀ A x − bᵀ x + Σ limit |x|: what dry friction makes of a motion. It takes what it can, and
// never turns it round.
Vector<2> with_dry_friction(const Matrix<2>& a, const Vector<2>& b, const Vector<2>& limit) noexcept {
  Vector<2> x = glm::inverse(a) * b;
  if (limit == Vector<2>{0.0}) return x;
  constexpr int sweeps = 12;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (glm::length_t i = 0; i < 2; ++i) {
      const double drive = b[i] - a[1 - i][i] * x[1 - i];
      x[i] = std::copysign(std::max(0.0, std::abs(drive) - limit[i]), drive) / a[i][i];
    }
  }
  return x;
}

}  // namespace

HaplyArms::HaplyArms(const ArmsGeometry& geometry, const Options& options, const Vector<2>& angles) noexcept
    : geometry_(geometry), options_(options), angles_(angles) {
  move_to(angles);
}

void HaplyArms::step(double duration, const Vector<2>& torques, const HandPull& hand) noexcept {
  const Matrix<2>& jacobian = place_.jacobian;
  const Matrix<2> across = glm::transpose(jacobian);
  const double pull = hand.holds_pose ? 0.0 : hand.stiffness;
  const double drag = hand.holds_pose || pull == 0.0 ? 0.0 : hand.damping;
  Matrix<2> inertia = diagonal(options_.inertias + duration * options_.damping) +
                      (options_.handle_mass + duration * drag + duration * duration * pull) * (across * jacobian);
  // The handle's own velocity goes in as it was: where the links have turned, it loses what they do not allow.
  Vector<2> momentum = options_.inertias * speeds_ + across * (options_.handle_mass * velocity_) +
                       duration * (torques + across * (pull * (hand.goal - place_.handle)));
  if (hand.holds_pose) {
    inertia += diagonal(Vector<2>{duration * (pose_damping + duration * pose_stiffness)});
    momentum += duration * pose_stiffness * (hand.pose - angles_);
  }
  Vector<2> speeds = with_dry_friction(inertia, momentum, duration * options_.friction);
  if (least_of(room(geometry_, angles_ + duration * speeds)) < edge) {
    speeds = held_by_ends(speeds, inertia, duration);
  }
  const double most = kinetic_energy() + stored_energy(hand) + duration * glm::dot(torques, speeds);
  if (!move_to(angles_ + duration * speeds)) speeds = Vector<2>{0.0};
  speeds_ = speeds;
  velocity_ = place_.jacobian * speeds;
  // What is bent about the way of a step may have given some energy, which is taken back.
  const double moving = kinetic_energy();
  const double may_move = std::max(0.0, most - stored_energy(hand));
  if (moving <= may_move + rounding) return;
  const double share = std::sqrt(may_move / moving);
  speeds_ *= share;
  velocity_ *= share;
}

double HaplyArms::stored_energy(const HandPull& hand) const noexcept {
  const Vector<2> way = hand.holds_pose ? angles_ - hand.pose : place_.handle - hand.goal;
  return 0.5 * (hand.holds_pose ? pose_stiffness : hand.stiffness) * glm::dot(way, way);
}

// Each end takes of the motion what leads beyond it, and gives none back.
Vector<2> HaplyArms::held_by_ends(Vector<2> speeds, const Matrix<2>& inertia, double duration) const noexcept {
  constexpr double small = 1e-7;  // [rad]
  const Matrix<2> mobility = glm::inverse(inertia);
  const auto here = room(geometry_, angles_);
  std::array<Vector<2>, ends> slopes{};
  for (glm::length_t i = 0; i < 2; ++i) {
    Vector<2> aside{0.0};
    aside[i] = small;
    const auto more = room(geometry_, angles_ + aside);
    const auto less = room(geometry_, angles_ - aside);
    for (std::size_t end = 0; end < ends; ++end) slopes[end][i] = (more[end] - less[end]) / (2.0 * small);
  }
  constexpr int sweeps = 8;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (std::size_t end = 0; end < ends; ++end) {
      const double beyond = std::min(here[end], edge) - here[end] - duration * glm::dot(slopes[end], speeds);
      const Vector<2> way = mobility * slopes[end];
      const double gain = duration * glm::dot(slopes[end], way);
      if (beyond > 0.0 && gain > 0.0) speeds += beyond / gain * way;
    }
  }
  for (int halving = 0; halving < 20; ++halving) {
    if (least_of(room(geometry_, angles_ + duration * speeds)) >= 0.0) return speeds;
    speeds *= 0.5;
  }
  return Vector<2>{0.0};
}

std::array<double, HaplyArms::ends> HaplyArms::room(const ArmsGeometry& geometry, const Vector<2>& angles) noexcept {
  const auto place = geometry.place(angles);
  if (!place) return {-1.0, -1.0, -1.0, -1.0};
  const Vector<2> between = place->elbow_2 - place->elbow_1;
  const Vector<2> base{geometry.apart, 0.0};
  const auto bend = [&](const Vector<2>& shaft, const Vector<2>& elbow) {
    const Vector<2> link = elbow - shaft;
    const Vector<2> to_handle = place->handle - elbow;
    return (link.x * to_handle.y - link.y * to_handle.x) / (geometry.driven * geometry.distal);
  };
  return {between.x - least_gap, most_stretched - glm::length(between) / (2.0 * geometry.distal),
          -bend(Vector<2>{0.0}, place->elbow_1) - least_bend, bend(base, place->elbow_2) - least_bend};
}

// False, and nothing is changed: there is no such place.
bool HaplyArms::move_to(const Vector<2>& angles) noexcept {
  const auto place = geometry_.place(angles);
  if (!place) return false;
  angles_ = angles;
  place_ = *place;
  return true;
}

Vector<2> HaplyArms::force_of(const Vector<2>& torques) const noexcept {
  return glm::inverse(glm::transpose(place_.jacobian)) * torques;
}

double HaplyArms::kinetic_energy() const noexcept {
  return 0.5 * glm::dot(options_.inertias * speeds_, speeds_) +
         0.5 * options_.handle_mass * glm::dot(velocity_, velocity_);
}

}  // namespace ghostforce
