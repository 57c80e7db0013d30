// Random but repeatable settings of the model, in any dimension. The same seed gives the same setting with every
// compiler and library, so a failing index can be tried again anywhere.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "core/actuation.h"
#include "core/stiffness.h"
#include "core/wall.h"

namespace ghostforce {

// SplitMix64; std::uniform_real_distribution differs from library to library.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

  double uniform(double from, double to) noexcept {
    return from + (to - from) * (static_cast<double>(next() >> 11) * 0x1p-53);
  }

  // Every decade is as likely as any other.
  double over_decades(double from, double to) noexcept { return std::exp(uniform(std::log(from), std::log(to))); }

  // One of 0 … count − 1.
  int below(int count) noexcept { return static_cast<int>(uniform(0.0, count)); }

  bool once_in(int count) noexcept { return below(count) == 0; }

  template <glm::length_t D>
  Vector<D> in_box(double half_width) noexcept {
    Vector<D> v;
    for (glm::length_t i = 0; i < D; ++i) v[i] = uniform(-half_width, half_width);
    return v;
  }

  // A unit vector, no direction preferred (Box and Muller's normal numbers, scaled).
  template <glm::length_t D>
  Vector<D> direction() noexcept {
    Vector<D> v;
    for (glm::length_t i = 0; i < D; ++i) {
      v[i] = std::sqrt(-2.0 * std::log(1.0 - uniform(0.0, 1.0))) * std::cos(uniform(0.0, 2.0 * std::numbers::pi));
    }
    return glm::normalize(v);
  }

 private:
  std::uint64_t next() noexcept {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

template <glm::length_t D>
struct Setting {
  Wall<D> wall;
  std::vector<Vector<D>> motors;  // orthonormal basis A of the actuated subspace, 1 to D − 1 directions
  Stiffnesses stiffnesses;
  double ratio;    // any ρ, not the optimal one
  Vector<D> goal;  // inside the wall [m]

  Actuation<D> actuation() const { return actuated_along<D>(std::span<const Vector<D>>(motors)); }
};

// Belief right, ratio optimal.
inline Stiffnesses make_stiffnesses(double k_u, double k_r, double k_t, double k_c) noexcept {
  Stiffnesses stiffnesses;
  stiffnesses.k_u = k_u;
  stiffnesses.k_r = k_r;
  stiffnesses.k_t = k_t;
  stiffnesses.k_c = k_c;
  return stiffnesses;
}

// An orthonormal basis of a random subspace.
template <glm::length_t D>
std::vector<Vector<D>> random_basis(Random& random, int directions) {
  std::vector<Vector<D>> basis;
  while (static_cast<int>(basis.size()) < directions) {
    Vector<D> v = random.direction<D>();
    for (const Vector<D>& b : basis) v -= b * glm::dot(b, v);
    if (glm::length(v) < 0.1) continue;  // too close to those before: it would lose digits
    v = glm::normalize(v);
    for (const Vector<D>& b : basis) v -= b * glm::dot(b, v);
    basis.push_back(glm::normalize(v));
  }
  return basis;
}

// Stiffnesses over four decades, any subspace of dimension 1 to D − 1, walls and goals within 100 mm; one constraint in
// five is hard.
template <glm::length_t D>
Setting<D> random_setting(Random& random) {
  Setting<D> setting;
  setting.wall = {random.in_box<D>(0.1), random.direction<D>()};
  setting.motors = random_basis<D>(random, 1 + random.below(D - 1));
  Stiffnesses& k = setting.stiffnesses;
  k.k_u = random.over_decades(1.0, 1e4);
  k.k_r = random.over_decades(1.0, 1e4);
  k.k_t = random.over_decades(1.0, 1e4);
  k.k_c = random.once_in(5) ? std::numeric_limits<double>::infinity() : random.over_decades(1e2, 1e6);
  setting.ratio = random.over_decades(1e-3, 1e3);
  setting.goal = random.in_box<D>(0.1);
  // Mirrored at the wall where it came out on the free side.
  if (const double outside = signed_distance(setting.wall, setting.goal); outside > 0.0) {
    setting.goal -= 2.0 * outside * setting.wall.normal;
  }
  return setting;
}

// The same with n in the span of the motors.
template <glm::length_t D>
Setting<D> random_setting_with_actuated_normal(Random& random) {
  Setting<D> setting = random_setting<D>(random);
  Vector<D> normal(0.0);
  while (glm::length(normal) < 0.1) {
    normal = Vector<D>(0.0);
    for (const Vector<D>& motor : setting.motors) normal += random.uniform(-1.0, 1.0) * motor;
  }
  const double depth_before = depth(setting.wall, setting.goal);
  setting.wall.normal = glm::normalize(normal);
  setting.goal =
      setting.wall.point + along(setting.wall, setting.goal - setting.wall.point) - depth_before * setting.wall.normal;
  return setting;
}

}  // namespace ghostforce
