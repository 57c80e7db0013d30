#include "core/loop_energy.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/core/random_setting.h"

namespace ghostforce::loop_energy_test {
namespace {

TEST(Circle, LiesInTheWallWhereverTheHandWas) {
  Random random(1);
  int moved = 0;
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const Wall<2> wall{random.in_box<2>(0.05), random.direction<2>()};
    const Vector<2> near = random.in_box<2>(0.1);
    CircleChoice choice;
    if (random.once_in(2)) choice.radius = random.uniform(0.002, 0.05);
    choice.is_clockwise = random.once_in(2);
    const Circle circle = circle_inside(wall, near, choice);
    EXPECT_EQ(circle.turns_per_second < 0.0, choice.is_clockwise);
    EXPECT_GE(circle.radius, 0.002);
    if (choice.radius) {
      EXPECT_EQ(circle.radius, *choice.radius);
    }
    for (double t = 0.0; t < 4.0; t += 0.1) {
      EXPECT_GT(depth(wall, position_on(circle, t)), 0.24 * circle.radius);
    }
    // Not moved along the wall, nor at all where it is deep enough.
    EXPECT_LT(glm::length(along(wall, circle.center - near)), 1e-15);
    if (depth(wall, near) >= 1.25 * circle.radius) {
      EXPECT_EQ(circle.center, near);
    } else {
      ++moved;
    }
  }
  EXPECT_GT(moved, 100);
}

TEST(LoopEnergyMeterTest, HasTheAreaOfACircleInEitherSenseAndTheEnergyOfTheLoop) {
  for (const double turns : {0.25, -0.25}) {
    const Circle circle{{0.3, -0.2}, 0.01, turns};
    LoopEnergyMeter meter(position_on(circle, 0.0), 5.0);
    for (int k = 1; k <= 4000; ++k) meter.add(position_on(circle, 0.001 * k), 5.0 + 0.25 * k);
    const double area = std::numbers::pi * 1e-4 * (turns > 0.0 ? 1.0 : -1.0);
    // A polygon of 4000 corners lacks (2π/4000)²/6 of the circle.
    EXPECT_NEAR(meter.loop().area / area, 1.0, 5e-7);
    EXPECT_EQ(meter.loop().energy, 1000.0);
  }
}

TEST(LoopEnergyMeterTest, ClosesTheLoopByAStraightLine) {
  LoopEnergyMeter meter({1.0, 1.0}, 0.0);
  meter.add({2.0, 1.0}, 0.0);
  meter.add({2.0, 2.0}, 0.0);
  EXPECT_EQ(meter.loop().area, 0.5);
}

}  // namespace
}  // namespace ghostforce::loop_energy_test
