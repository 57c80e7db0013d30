#include "core/tremor_and_drift.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "core/tick.h"

namespace ghostforce::simulated_hand_test {
namespace {

constexpr double rate = 1000.0;
constexpr double duration_s = 8.0;
const GoalPath aim{.points = {{0.0, 0.0}, {0.05, -0.02}}, .times = {0.0, 1.0}, .motion = Motion::linear};

// What the tremor adds, along one axis.
std::vector<double> shaking(const Tremor& tremor, glm::length_t axis) {
  GoalPath smooth = aim;
  smooth.motion = Motion::minimum_jerk;
  std::vector<double> values;
  const GoalPath hand = simulated_hand(aim, tremor, duration_s, rate);
  for (std::size_t k = 0; k < hand.points.size(); ++k) {
    values.push_back(hand.points[k][axis] - goal_at(smooth, hand.times[k])[axis]);
  }
  return values;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// Of the part at one frequency.
double amplitude(const std::vector<double>& values, double hz) {
  double cosine = 0.0;
  double sine = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double angle = 2.0 * std::numbers::pi * hz * static_cast<double>(k) / rate;
    // A window, or the ends would leak into other frequencies.
    const double share = static_cast<double>(k) / static_cast<double>(values.size());
    const double window = 1.0 - std::cos(2.0 * std::numbers::pi * share);
    cosine += window * values[k] * std::cos(angle);
    sine += window * values[k] * std::sin(angle);
  }
  return 2.0 * std::hypot(cosine, sine) / static_cast<double>(values.size());
}

TEST(SimulatedHand, HasAWaypointPerTickOnItsWay) {
  const GoalPath hand = simulated_hand(aim, {.rms = 0.0}, 2.0, rate);
  ASSERT_EQ(hand.points.size(), 2001U);
  EXPECT_EQ(hand.times.back(), 2.0);
  EXPECT_EQ(hand.times[3], time_of(3, rate));
  EXPECT_EQ(hand.points.front(), aim.points.front());
  EXPECT_EQ(hand.points.back(), aim.points.back());
  // Minimum jerk: slow at the ends, 15/8 of the mean speed in the middle.
  const auto speed_at = [&](std::size_t k) { return glm::distance(hand.points[k + 1], hand.points[k]) * rate; };
  EXPECT_LT(speed_at(0), 1e-6);
  EXPECT_NEAR(speed_at(500) / glm::distance(aim.points[0], aim.points[1]), 15.0 / 8.0, 1e-4);
}

TEST(SimulatedHand, ShakesAsMuchAsAskedInItsBandAndNowhereElse) {
  for (const double wanted : {0.0001, 0.0003}) {
    for (const glm::length_t axis : {0, 1}) {
      const std::vector<double> values = shaking({.rms = wanted, .seed = 7}, axis);
      // 24 waves, a sixth of a hertz apart, over 8 s: they do not quite average out.
      EXPECT_NEAR(rms(values), wanted, 0.15 * wanted);
      double inside = 0.0;
      double outside = 0.0;
      for (double hz = 0.5; hz < 40.0; hz += 0.125) {
        double& most = hz > 7.5 && hz < 12.5 ? inside : outside;
        most = std::max(most, amplitude(values, hz));
      }
      EXPECT_GT(inside, 20.0 * outside);
    }
  }
}

TEST(SimulatedHand, IsTheSameForTheSameSeedAlone) {
  const auto hand = [](std::uint64_t seed) { return simulated_hand(aim, {.seed = seed}, 1.0, rate).points; };
  EXPECT_EQ(hand(1), hand(1));
  EXPECT_NE(hand(1), hand(2));
  const std::vector<double> x = shaking({}, 0);
  const std::vector<double> y = shaking({}, 1);
  double together = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) together += x[k] * y[k];
  // The axes shake apart.
  EXPECT_LT(std::abs(together) / static_cast<double>(x.size()), 0.5 * rms(x) * rms(y));
}

// Worked out by another program from the definition of SplitMix64: no machine's standard library has a say in it.
TEST(SimulatedHand, IsThisOne) {
  const GoalPath hand = simulated_hand(aim, {.rms = 0.001, .seed = 1}, 0.001, rate);
  EXPECT_NEAR(hand.points[0].x, -0.002247213, 1e-9);
  EXPECT_NEAR(hand.points[0].y, 0.000381262, 1e-9);
}

}  // namespace
}  // namespace ghostforce::simulated_hand_test
