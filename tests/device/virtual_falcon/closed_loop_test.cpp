// The paper's experiment (section 6.2) through the driver: a hand, a Falcon of which only the horizontal axis is
// actuated, and a slanted wall. Everything that a program can get wrong between a wall and a hand lies in between:
// frames, encoders, kinematics, Jacobian, motor counts, sampling.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/equilibrium.h"
#include "core/motor_heat.h"
#include "tests/device/virtual_falcon/rehearsal.h"

namespace ghostforce::closed_loop_test {
namespace {

constexpr Vector<2> goal{0.02, -0.02};

// Where the hand comes to rest under a strategy, in truth and not as the driver sees it: the mean of a second, for a
// hand that holds quite still is asked now and then whether its encoders still count, and moves by a tenth of a
// millimetre.
Vector<2> rest_under(Rehearsal& rehearsal, StrategyId id) {
  rehearsal.use(id);
  rehearsal.input().move_to(goal, 1.0);
  rehearsal.run(4.0);
  Vector<2> sum(0.0);
  for (int tick = 0; tick < 1000; ++tick) {
    rehearsal.step();
    sum += rehearsal.tip();
  }
  EXPECT_EQ(rehearsal.motors().state, SafetyState::on);
  return sum / 1000.0;
}

// At (20, −20) mm no force is clipped, so that the closed forms hold. Half a count of each motor is worth 25 µm at
// worst, and the force that it misplaces moves the hand by k_r / k_u as much again.
constexpr double resolution = 25e-6;

TEST(ClosedLoop, TheHandEndsWhereTheTheorySaysUnderEveryStrategy) {
  Rehearsal rehearsal;
  rehearsal.turn_on();
  const Settings& settings = rehearsal.command().settings;
  for (const Strategy& entry : strategy_catalog()) {
    const Vector<2> tip = rest_under(rehearsal, entry.id);
    const Vector<2> theory = equilibrium_of(entry.id, settings, goal).device;
    const double k_r_over_k_u = settings.stiffnesses.k_r / settings.stiffnesses.k_u;
    EXPECT_NEAR(tip.x, theory.x, resolution * (1.0 + k_r_over_k_u)) << entry.name;
    EXPECT_NEAR(tip.y, theory.y, resolution * (1.0 + k_r_over_k_u)) << entry.name;
    rehearsal.input().move_to(Rehearsal::free_place, 0.5);
    rehearsal.run(2.0);
  }
}

TEST(ClosedLoop, NaiveRenderingDragsTheHandFarToTheLeftAndTheAnisotropicOneDoesNot) {
  Rehearsal rehearsal;
  rehearsal.turn_on();
  const Vector<2> full = rest_under(rehearsal, StrategyId::full);
  const Vector<2> naive = rest_under(rehearsal, StrategyId::naive);
  const Vector<2> anisotropic = rest_under(rehearsal, StrategyId::anisotropic);
  EXPECT_LT(naive.x, full.x - 0.008);  // the ghost force
  EXPECT_LT(naive.x, 0.0);             // on the other side of where it entered
  EXPECT_NEAR(anisotropic.x, full.x, 2.0 * resolution);
  // Without a motor on it, the vertical axis stays with the hand's goal.
  EXPECT_NEAR(naive.y, goal.y, 2.0 * resolution);
  EXPECT_NEAR(anisotropic.y, goal.y, 2.0 * resolution);
}

TEST(ClosedLoop, TheInferredGoalIsTheHandsWhenTheBeliefIsRight) {
  Rehearsal rehearsal;
  rehearsal.turn_on();
  rest_under(rehearsal, StrategyId::naive);
  const Snapshot& snapshot = rehearsal.report().snapshot;
  ASSERT_EQ(snapshot.measured, StrategyId::naive);
  EXPECT_NEAR(glm::length(snapshot.goal - goal), 0.0, 10.0 * resolution);
  rehearsal.command().settings.stiffnesses.believed_k_u = 50.0;
  ++rehearsal.command().settings_generation;
  rehearsal.run(1.0);
  EXPECT_GT(glm::length(rehearsal.report().snapshot.goal - goal), 0.01);
}

TEST(ClosedLoop, AWrongBeliefLeavesAGhostForce) {
  Rehearsal rehearsal;
  rehearsal.turn_on();
  const double full = rest_under(rehearsal, StrategyId::full).x;
  rehearsal.command().settings.stiffnesses.believed_k_u = 300.0;
  const double wrong = rest_under(rehearsal, StrategyId::anisotropic).x;
  const double theory = equilibrium_of(StrategyId::anisotropic, rehearsal.command().settings, goal).device.x;
  EXPECT_GT(std::abs(wrong - full), 1e-3);
  EXPECT_NEAR(wrong, theory, 10.0 * resolution);
}

// The heat is that of the numbers that went to the motors, whatever force they were for.
TEST(ClosedLoop, TheMotorsGrowAsWarmAsWhatTheyWereToldToGiveMakesThem) {
  Rehearsal rehearsal;
  rehearsal.turn_on();
  rehearsal.use(StrategyId::naive);
  rehearsal.input().move_to(goal, 1.0);
  rehearsal.run(3.0);
  const MotorHeats before = rehearsal.motors().heat;
  MotorNumbers held = rehearsal.falcon().motors;
  std::array<double, 3> squares{};
  for (int tick = 0; tick < 5000; ++tick) {
    for (std::size_t motor = 0; motor < 3; ++motor) squares[motor] += 1e-3 * held[motor] * held[motor];
    rehearsal.step();
    held = rehearsal.falcon().motors;
  }
  const double decay = std::exp(-5.0 / motor_heat_time_constant_s);
  for (std::size_t motor = 0; motor < 3; ++motor) {
    const double load = squares[motor] / 5.0 / std::pow(motor_continuous_share * most_motor_counts, 2.0);
    const double now = rehearsal.motors().heat[motor];
    EXPECT_NEAR(now, before[motor] * decay + load * (1.0 - decay), 0.01 * now) << motor;
  }
  EXPECT_GT(std::ranges::max(rehearsal.motors().heat), std::ranges::max(before));
  ++rehearsal.command().offs_asked;
  rehearsal.run(1.0);  // they fade
  const double when_off = rehearsal.motors().heat[0];
  rehearsal.run(5.0);
  EXPECT_NEAR(rehearsal.motors().heat[0], when_off * decay, 1e-9);
}

// Pushing far: the clamp keeps the force's direction, also through kinematics and motors.
TEST(ClosedLoop, TheForceOnTheHandHasTheDirectionThatWasAskedFor) {
  Rehearsal rehearsal;
  rehearsal.turn_on();
  rehearsal.use(StrategyId::full);
  rehearsal.input().move_to({0.04, -0.04}, 1.0);
  rehearsal.run(3.0);
  ASSERT_EQ(rehearsal.motors().state, SafetyState::on);
  const Vector<3> force = rehearsal.input().link().arm().force();
  const Vector<2> wanted = rehearsal.motors().sent;
  // Whole motor counts turn a force by 0.1° at 3 N, and the encoders' rounding adds less.
  const Vector<2> got{force.x, force.y};
  EXPECT_NEAR(std::atan2(got.y, got.x), std::atan2(wanted.y, wanted.x), 0.15 * std::acos(-1.0) / 180.0);
  EXPECT_NEAR(glm::length(got), glm::length(wanted), 0.01 * glm::length(wanted));
  EXPECT_NEAR(force.z, 0.0, 0.01 * glm::length(wanted));  // the third axis is held by nothing
}

// A weak motor gets more counts. Were it not weak, it would push so much harder: the limit of force holds for that too.
TEST(ClosedLoop, LimitHoldsForAMotorThatIsTakenForWeak) {
  FalconCalibration calibration;
  calibration.serial = *DeviceSerial::from(VirtualLink::serial_number);
  calibration.motor_strengths = {1.0, 0.5, 0.8};
  FalconOptions options;
  options.calibrations = {calibration};
  Rehearsal rehearsal({}, options);
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::idle));
  EXPECT_DOUBLE_EQ(rehearsal.input().force_uncertainty(), 2.0 * 6600.0 / smallest_published_motor_constant);
}

}  // namespace
}  // namespace ghostforce::closed_loop_test
