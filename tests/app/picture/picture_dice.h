// Settings and goals by dice, and windows to show them in: any settings, any goal that a pointer can reach, any window.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>
#include <string_view>

#include "core/simulate.h"

namespace ghostforce {

class PictureDice {
 public:
  explicit PictureDice(unsigned seed) : random_(seed) {}

  double between(double least, double greatest) {
    return std::uniform_real_distribution<double>(least, greatest)(random_);
  }
  double decades(double least, double greatest) { return std::pow(10.0, between(least, greatest)); }
  bool one_in(int count) { return std::uniform_int_distribution<int>(1, count)(random_) == 1; }
  template <typename T, std::size_t count>
  const T& one_of(const std::array<T, count>& all) {
    return all[std::uniform_int_distribution<std::size_t>(0, count - 1)(random_)];
  }

  Settings settings() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Settings made;
    made.wall_point = one_in(4) ? Vector<2>(between(-1.0, 1.0), between(-1.0, 1.0))
                                : Vector<2>(between(-0.05, 0.05), between(-0.05, 0.05));
    // Right angles and no angles are the ones that go wrong.
    const auto angle = [&] {
      return one_in(4) ? 0.25 * std::numbers::pi * std::floor(between(-8.0, 8.0)) : between(-7.0, 7.0);
    };
    made.wall_normal_angle = angle();
    made.actuated_angle =
        one_in(6) ? made.wall_normal_angle + 0.5 * std::numbers::pi * std::floor(between(0.0, 4.0)) : angle();
    made.mass = decades(-1.5, 0.5);
    made.damping = decades(0.0, 1.3);
    made.rate = 1000.0;
    const bool is_usual = !one_in(4);
    Stiffnesses& all = made.stiffnesses;
    all.k_u = is_usual ? decades(1.7, 2.9) : decades(-1.0, 6.0);
    all.k_r = is_usual ? all.k_u * decades(-0.3, 1.3) : one_in(12) ? 0.0 : decades(-1.0, 6.0);
    all.k_t = is_usual ? all.k_r * decades(-0.7, 0.7) : decades(-1.0, 6.0);
    all.k_c = one_in(3) ? infinity : is_usual ? decades(2.5, 6.0) : decades(0.0, 9.0);
    if (one_in(3)) {
      const double believed = one_in(5) ? all.k_u : all.k_u * decades(-1.5, 1.5);
      all.believed_k_u = user_stiffness_range.nearest_to(believed);
    }
    if (one_in(8)) all.chosen_tracking_ratio = one_in(4) ? 1.0 : decades(-3.0, 3.0);
    made.active = one_of(std::array{StrategyId::full, StrategyId::naive, StrategyId::naive, StrategyId::anisotropic});
    return made;
  }

  // In the wall for the most part.
  Vector<2> goal(const Settings& settings) {
    const Wall<2> wall = wall_of(settings);
    const Vector<2> along{-wall.normal.y, wall.normal.x};
    const double depth = one_in(6) ? -between(0.0, 0.02) : one_in(6) ? between(0.0, 0.0005) : between(0.0, 0.05);
    return wall.point + along * between(-0.03, 0.03) - wall.normal * depth;
  }

  // Some motion from rest under one goal to rest under another, stopped somewhere.
  Snapshot moving_snapshot(const Settings& settings, const Vector<2>& from, const Vector<2>& to) {
    const TickCoefficients<2> coefficients = coefficients_of(settings);
    TickState<2> state = equilibrium_state(settings, from);
    const int ticks = static_cast<int>(between(1.0, 300.0));
    for (int i = 1; i <= ticks; ++i) {
      const double share = std::min(1.0, i / 100.0);
      tick(coefficients, from + (to - from) * share, state);
    }
    return snapshot_of(coefficients, state);
  }

  Vector<2> size() {
    return one_of(std::array{Vector<2>(1024.0, 640.0), Vector<2>(1024.0, 768.0), Vector<2>(1280.0, 720.0),
                             Vector<2>(1280.0, 800.0), Vector<2>(1366.0, 768.0), Vector<2>(1600.0, 1200.0),
                             Vector<2>(1920.0, 1080.0), Vector<2>(2560.0, 1440.0), Vector<2>(3440.0, 1440.0),
                             Vector<2>(3840.0, 2160.0),
                             Vector<2>(std::round(between(1024.0, 3840.0)), std::round(between(640.0, 2160.0)))});
  }
  double scale() { return one_in(3) ? between(0.75, 3.0) : one_of(std::array{0.75, 1.0, 1.0, 1.5, 2.0, 3.0}); }
  std::string_view theme() { return one_of(std::array<std::string_view, 3>{"light", "dark", "projector"}); }

 private:
  std::mt19937 random_;
};

inline Snapshot snapshot_at_rest_of_all(const Settings& settings, const Vector<2>& goal) {
  return snapshot_of(coefficients_of(settings), equilibrium_state(settings, goal));
}

}  // namespace ghostforce
