// The heat of a motor, against the closed form of its differential equation.
#include "core/motor_heat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ghostforce::motor_heat_test {
namespace {

constexpr double tau_s = motor_heat_time_constant_s;

// Ticks of a millisecond.
MotorHeat held(MotorHeat heat, double share, double seconds) {
  for (int tick = 0; tick < std::lround(1000.0 * seconds); ++tick) heat.hold(share, 0.001);
  return heat;
}

TEST(MotorHeat, AStepRisesAsTheClosedFormSaysAndFallsAsItSays) {
  for (const double share : {0.1, -0.25, 0.5, 1.0}) {
    const double in_the_end = share * share * 16.0;
    MotorHeat heat;
    for (int second = 1; second <= 90; ++second) {
      heat = held(heat, share, 1.0);
      // Each of the ticks rounds once.
      ASSERT_NEAR(heat.heat(), in_the_end * (1.0 - std::exp(-second / tau_s)), 1e-11) << share;
    }
    const double before = heat.heat();
    EXPECT_NEAR(held(heat, 0.0, 30.0).heat(), before * std::exp(-30.0 / tau_s), 1e-11);
  }
}

TEST(MotorHeat, WhatItMayGiveForEverEndsAtOne) {
  MotorHeat heat;
  heat.hold(motor_continuous_share, 1e6);
  EXPECT_DOUBLE_EQ(heat.heat(), 1.0);
}

TEST(MotorHeat, IsTheSameHoweverTheTimeIsCut) {
  MotorHeat at_once;
  at_once.hold(0.7, 12.0);
  EXPECT_NEAR(held({}, 0.7, 12.0).heat(), at_once.heat(), 1e-12);
}

// Pushes to and fro count as what they are in the mean square, and not in the mean.
TEST(MotorHeat, FollowsTheMeanSquare) {
  MotorHeat heat;
  for (int tick = 0; tick < 600'000; ++tick) heat.hold(tick % 2 == 0 ? 0.3 : -0.1, 0.001);
  EXPECT_NEAR(heat.heat(), 16.0 * 0.5 * (0.09 + 0.01), 1e-4);
}

TEST(MotorHeat, SaysHowLongItHasToRest) {
  for (const double heat : {0.6, 1.0, 4.0}) {
    MotorHeat motor;
    motor.hold(motor_continuous_share * std::sqrt(heat), 1e9);
    motor.hold(0.0, motor_rest_s(motor.heat()));
    EXPECT_NEAR(motor.heat(), 0.5, 1e-12);
  }
  EXPECT_EQ(motor_rest_s(0.4), 0.0);
}

TEST(MotorHeat, NothingHappensInNoTimeOrByWhatIsNoNumber) {
  MotorHeat heat = held({}, 0.5, 1.0);
  const double before = heat.heat();
  heat.hold(1.0, 0.0);
  heat.hold(1.0, -1.0);
  heat.hold(1.0, std::numeric_limits<double>::quiet_NaN());
  heat.hold(std::numeric_limits<double>::infinity(), 1.0);
  EXPECT_EQ(heat.heat(), before);
}

}  // namespace
}  // namespace ghostforce::motor_heat_test
