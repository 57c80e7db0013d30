// The simulated arm: it rests where the forces balance, makes no energy, and stays where it is held, whatever it is
// done.
#include "device/virtual_falcon/arm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace ghostforce::arm_test {
namespace {

constexpr double dt = 1e-4;
constexpr MotorNumbers no_motors{};

void rest(SimulatedArm& arm, const MotorNumbers& motors, const Vector<3>& goal, double stiffness) {
  for (int i = 0; i < 20'000; ++i) arm.step(dt, motors, goal, stiffness);
}

void expect_inside(const SimulatedArm& arm) {
  constexpr double rounding = 1e-12;
  const Vector<3>& at = arm.position();
  ASSERT_TRUE(std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z));
  ASSERT_GE(at.z, SimulatedArm::nearest - rounding);
  ASSERT_LE(at.z, SimulatedArm::farthest + rounding);
  ASSERT_LE(std::hypot(at.x, at.y), SimulatedArm::radius + rounding);
}

TEST(SimulatedArm, EncodersAreTheLegsAnglesInWholeCounts) {
  SimulatedArm arm({.start = {0.0, 0.0, 0.12}});
  EXPECT_EQ(arm.encoders(), (std::array<int, 3>{-304, -304, -304}));
  SimulatedArm moved({.start = {0.01, -0.015, 0.12}});
  const FalconGeometry geometry;
  const auto angles = FalconKinematics(geometry).angles(moved.position());
  ASSERT_TRUE(angles);
  const Vector<3> counts = counts_of_angles(*angles, geometry);
  for (glm::length_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(moved.encoders()[static_cast<std::size_t>(i)], counts[i], 0.5);
  }
}

TEST(SimulatedArm, GoesWhereTheHandPullsIt) {
  SimulatedArm arm({});
  const Vector<3> goal{0.02, -0.01, 0.13};
  rest(arm, no_motors, goal, 100.0);
  EXPECT_LT(glm::length(arm.position() - goal), 1e-9);
}

TEST(SimulatedArm, RestsWhereTheForcesBalance) {
  const FalconGeometry geometry;
  const FalconKinematics kinematics(geometry);
  for (const MotorNumbers& motors : {MotorNumbers{300, 300, 300}, MotorNumbers{500, -200, 100}}) {
    SimulatedArm arm({});
    const Vector<3> goal{0.0, 0.01, 0.12};
    constexpr double stiffness = 200.0;
    rest(arm, motors, goal, stiffness);
    const auto jacobian = kinematics.jacobian(arm.position());
    ASSERT_TRUE(jacobian);
    const Vector<3> force = force_of_motor_counts(vector_of(motors), *jacobian, Vector<3>(6600.0));
    EXPECT_GT(glm::length(force), 0.5);
    // Far below one count, which is some 15 µm.
    EXPECT_LT(glm::length(goal + force / stiffness - arm.position()), 1e-7);
    EXPECT_LT(glm::length(arm.force() - force), 1e-6);
  }
}

TEST(SimulatedArm, PositiveNumbersPullTheHandleIn) {
  SimulatedArm arm({.start = {0.0, 0.0, 0.125}});
  arm.step(dt, {1000, 1000, 1000}, {}, 0.0);
  EXPECT_LT(arm.force().z, -1.0);
  EXPECT_LT(arm.velocity().z, 0.0);
}

// A spring's and a mass's. Damping is left out, so that nothing else could hide what the integrator gives.
TEST(SimulatedArm, EnergyNeverGrowsWithoutMotors) {
  std::mt19937 random{1};
  std::uniform_real_distribution<double> any(-0.15, 0.15);
  for (int i = 0; i < 50; ++i) {
    SimulatedArm arm({.damping = 0.0, .start = {any(random), any(random), 0.12 + any(random)}});
    // Many of these lie outside the stops.
    const Vector<3> goal{any(random), any(random), 0.12 + any(random)};
    constexpr double stiffness = 1000.0;
    double energy = std::numeric_limits<double>::infinity();
    for (int step = 0; step < 2000; ++step) {
      arm.step(dt, no_motors, goal, stiffness);
      const Vector<3> stretch = goal - arm.position();
      const double now = 0.05 * glm::dot(arm.velocity(), arm.velocity()) + 0.5 * stiffness * glm::dot(stretch, stretch);
      ASSERT_LE(now, energy * (1.0 + 1e-12));
      energy = now;
    }
    expect_inside(arm);
  }
}

TEST(SimulatedArm, HostileMotorsCannotThrowItOutOfItself) {
  std::mt19937 random{2};
  std::uniform_int_distribution<int> number(-4095, 4095);
  std::uniform_int_distribution<int> hold(1, 2000);
  SimulatedArm arm({.mass = 0.01, .damping = 0.0});
  MotorNumbers motors{};
  int left = 0;
  for (int i = 0; i < 100'000; ++i) {
    if (left-- == 0) {
      left = hold(random);
      for (std::int16_t& motor : motors) motor = static_cast<std::int16_t>(number(random));
    }
    arm.step(dt, motors, {}, 0.0);
    expect_inside(arm);
    if (HasFatalFailure()) return;
  }
}

TEST(SimulatedArm, StandsAtTheStopsAndComesBack) {
  SimulatedArm arm({});
  rest(arm, no_motors, {0.0, 0.0, 0.0}, 200.0);
  EXPECT_NEAR(arm.position().z, SimulatedArm::nearest, 1e-12);
  EXPECT_EQ(arm.velocity(), Vector<3>(0.0));
  rest(arm, no_motors, {0.2, 0.0, 0.1}, 200.0);
  EXPECT_NEAR(arm.position().x, SimulatedArm::radius, 1e-12);
  // Along the narrowing side to the far end.
  rest(arm, no_motors, {0.0, 0.0, 0.3}, 200.0);
  EXPECT_NEAR(arm.position().z, SimulatedArm::farthest, 1e-12);
  rest(arm, no_motors, {0.0, 0.0, 0.12}, 200.0);
  EXPECT_LT(glm::length(arm.position() - Vector<3>{0.0, 0.0, 0.12}), 1e-9);
}

// A weight and what hangs on it pull down; friction holds what is not pulled enough, and slows what is.
TEST(SimulatedArm, HasAWeightAndJointsThatRub) {
  constexpr Vector<3> goal{0.0, 0.0, 0.12};
  constexpr double stiffness = 100.0;
  SimulatedArm arm({.weight = 0.5, .start = goal});
  for (int i = 0; i < 20'000; ++i) arm.step(dt, no_motors, goal, stiffness, 0.3);
  EXPECT_NEAR(arm.position().y, -0.8 / stiffness, 1e-9);
  EXPECT_NEAR(arm.position().x, 0.0, 1e-9);
  SimulatedArm stuck({.friction = 0.2, .start = goal});
  rest(stuck, no_motors, goal + Vector<3>(0.0019, 0.0, 0.0), stiffness);
  EXPECT_EQ(stuck.position(), goal) << "0.19 N do not move it";
  rest(stuck, no_motors, goal + Vector<3>(0.01, 0.0, 0.0), stiffness);
  EXPECT_GT(stuck.position().x, 0.005);
  EXPECT_EQ(stuck.velocity(), Vector<3>(0.0));
  EXPECT_LE(std::abs(0.01 - stuck.position().x) * stiffness, 0.2 + 1e-9);
}

TEST(SimulatedArm, TakesNoEnergyFromItsFriction) {
  std::mt19937 random{3};
  std::uniform_real_distribution<double> any(-0.05, 0.05);
  for (int i = 0; i < 20; ++i) {
    SimulatedArm arm({.damping = 0.0, .friction = 0.3, .start = {any(random), any(random), 0.12}});
    const Vector<3> goal{any(random), any(random), 0.12};
    double energy = std::numeric_limits<double>::infinity();
    for (int step = 0; step < 40'000; ++step) {
      arm.step(dt, no_motors, goal, 500.0);
      const Vector<3> stretch = goal - arm.position();
      const double now = 0.05 * glm::dot(arm.velocity(), arm.velocity()) + 250.0 * glm::dot(stretch, stretch);
      ASSERT_LE(now, energy * (1.0 + 1e-12));
      energy = now;
    }
    EXPECT_EQ(arm.velocity(), Vector<3>(0.0)) << "it ends";
  }
}

TEST(SimulatedArm, CanBeWiredOtherwise) {
  constexpr Vector<3> place{0.01, -0.015, 0.12};
  const SimulatedArm usual({.start = place});
  const SimulatedArm wired({.encoder_of_leg = {3, -1, 2}, .start = place});
  EXPECT_EQ(wired.encoders()[2], usual.encoders()[0]);
  EXPECT_EQ(wired.encoders()[1], usual.encoders()[2]);
  const SimulatedArm pushed_in({.start = {0.0, 0.0, SimulatedArm::nearest}});
  EXPECT_EQ(wired.encoders()[0] + usual.encoders()[1], 2 * pushed_in.encoders()[0]) << "mirrored at the stop";
  SimulatedArm pushed({.motor_strengths = {1.0, 0.5, 1.0}, .motor_of_leg = {2, -1, 3}, .start = place});
  pushed.step(dt, {-400, 300, 200}, place, 0.0);
  SimulatedArm same({.start = place});
  same.step(dt, {300, 200, 200}, place, 0.0);
  EXPECT_LT(glm::length(pushed.force() - same.force()), 1e-12);
}

// The legs' reach ends inside the stops with some of the published lengths: it waits there, and can leave.
TEST(SimulatedArm, WorksWithEachGeometry) {
  for (const GeometryPreset& preset : geometry_catalog()) {
    SCOPED_TRACE(preset.name);
    SimulatedArm arm({.geometry = preset.geometry});
    for (const Vector<3>& far : {Vector<3>{0.3, 0.0, 0.1}, Vector<3>{0.0, 0.0, 0.3}, Vector<3>{0.1, -0.3, 0.2}}) {
      rest(arm, no_motors, far, 200.0);
      expect_inside(arm);
      rest(arm, no_motors, {0.0, 0.0, 0.11}, 200.0);
      EXPECT_LT(glm::length(arm.position() - Vector<3>{0.0, 0.0, 0.11}), 1e-6);
    }
  }
}

}  // namespace
}  // namespace ghostforce::arm_test
