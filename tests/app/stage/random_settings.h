// Settings by dice: any that a scene may hold, spread over the orders of magnitude; and such as none may.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include "core/settings.h"

namespace ghostforce {

class RandomSettings {
 public:
  explicit RandomSettings(unsigned seed) : random_(seed) {}

  double between(double least, double greatest) {
    return std::uniform_real_distribution<double>(least, greatest)(random_);
  }
  bool coin() { return between(0.0, 1.0) < 0.5; }

  Settings next() {
    Settings settings;
    settings.wall_point = {between(-0.1, 0.1), between(-0.1, 0.1)};
    settings.wall_normal_angle = between(-20.0, 20.0);
    settings.actuated_angle = between(-20.0, 20.0);
    settings.mass = 0.1;
    settings.damping = 5.0;
    settings.rate = 1000.0;
    Stiffnesses& stiffnesses = settings.stiffnesses;
    stiffnesses.k_u = decades(1.0, 3.0);
    stiffnesses.k_r = stiffnesses.k_u * decades(-0.3, 2.3);
    stiffnesses.k_t = stiffnesses.k_r * decades(-1.0, 0.4);
    stiffnesses.k_c = coin() ? std::numeric_limits<double>::infinity() : decades(2.0, 7.0);
    if (coin()) stiffnesses.believed_k_u = stiffnesses.k_u * decades(-2.0, 2.0);
    if (between(0.0, 1.0) < 0.2) stiffnesses.chosen_tracking_ratio = decades(-2.0, 3.0);
    return settings;
  }

  // Numbers that no scene may hold among them.
  Settings hostile() {
    Settings settings = next();
    Stiffnesses& stiffnesses = settings.stiffnesses;
    for (double* const number : {&settings.wall_normal_angle, &settings.actuated_angle, &stiffnesses.k_u,
                                 &stiffnesses.k_r, &stiffnesses.k_t, &stiffnesses.k_c}) {
      if (coin()) *number = hostile_number();
    }
    if (coin()) stiffnesses.believed_k_u = hostile_number();
    if (coin()) stiffnesses.chosen_tracking_ratio = hostile_number();
    return settings;
  }

  double hostile_number() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    constexpr std::array numbers{0.0, -0.0, -1.0, 5e-324, 1e-300, 1e6, 1e300, -1e300, infinity, -infinity, none};
    return numbers[std::uniform_int_distribution<std::size_t>(0, numbers.size() - 1)(random_)];
  }

 private:
  double decades(double least, double greatest) { return std::pow(10.0, between(least, greatest)); }

  std::mt19937 random_;
};

}  // namespace ghostforce
