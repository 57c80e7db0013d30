// What a weight on the handle says about the motors.
#include "app/tools/doctor/motors.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "device/falcon/kinematics.h"

namespace ghostforce::motor_constants_test {
namespace {

constexpr std::array places{Vector<3>{0.0, 0.0, 0.125}, Vector<3>{-0.03, -0.025, 0.138}};

struct Truth {
  double constant = 6600.0;
  Vector<3> strengths{1.0};
  double handle = 0.4;     // weight [N]
  double friction = 0.05;  // [N]
};

// As the motors of such a device must be driven, with a force that wobbles by so much [N].
std::array<WeightReading, 2> readings_of(const Truth& truth, double weight, double wobble, std::mt19937& random) {
  std::normal_distribution<double> off(0.0, 1.0);
  std::array<WeightReading, 2> readings;
  for (std::size_t i = 0; i < places.size(); ++i) {
    readings[i].weight = weight;
    readings[i].jacobian = *FalconKinematics(FalconGeometry{}).jacobian(places[i]);
    const auto counts = [&](double load, double sense) {
      const Vector<3> force(wobble * off(random), truth.handle + load + sense * truth.friction + wobble * off(random),
                            wobble * off(random));
      return -truth.constant / truth.strengths * joint_torques(force, readings[i].jacobian).value();
    };
    readings[i].without = {.up = counts(0.0, 1.0), .down = counts(0.0, -1.0)};
    readings[i].with_weight = {.up = counts(weight, 1.0), .down = counts(weight, -1.0)};
  }
  return readings;
}

TEST(MotorConstants, OfMotorsThatAreAlike) {
  std::mt19937 random{1};
  for (const double constant : {3530.0, 6600.0, 10000.0}) {
    const MotorConstants found = find_motor_constants(readings_of({.constant = constant}, 0.49, 0.0, random));
    ASSERT_TRUE(found.is_found);
    EXPECT_TRUE(found.are_alike);
    EXPECT_NEAR(found.counts_per_newton_metre, constant, 1e-6 * constant);
    EXPECT_GT(found.uncertainty, 0.005 * constant);
    EXPECT_LT(found.uncertainty, 0.06 * constant);
    EXPECT_EQ(found.strengths, Vector<3>(1.0));
    EXPECT_NEAR(found.friction, 0.05, 1e-9);
    EXPECT_NEAR(found.handle_weight, 0.4, 1e-9);
  }
}

TEST(MotorConstants, FindsTheWeakOne) {
  std::mt19937 random{2};
  for (glm::length_t weak = 0; weak < 3; ++weak) {
    Truth truth;
    truth.strengths[weak] = 0.6;
    const MotorConstants found = find_motor_constants(readings_of(truth, 0.49, 0.0, random));
    ASSERT_TRUE(found.is_found);
    EXPECT_FALSE(found.are_alike) << weak;
    EXPECT_NEAR(found.counts_per_newton_metre, 6600.0, 1.0);
    for (glm::length_t leg = 0; leg < 3; ++leg) {
      EXPECT_NEAR(found.strengths[leg], truth.strengths[leg], 1e-6);
      EXPECT_GT(found.strength_uncertainties[leg], 0.0);
      EXPECT_LT(found.strength_uncertainties[leg], 0.2);
    }
  }
}

// Two standard deviations hold 95 of 100; of 200, 176 or more is what chance leaves of that.
TEST(MotorConstants, AreAsUncertainAsTheySay) {
  std::mt19937 random{3};
  int within = 0;
  for (int i = 0; i < 200; ++i) {
    const MotorConstants found = find_motor_constants(readings_of({.constant = 5200.0}, 0.49, 0.008, random));
    ASSERT_TRUE(found.is_found);
    within += std::abs(found.counts_per_newton_metre - 5200.0) <= found.uncertainty ? 1 : 0;
  }
  EXPECT_GE(within, 176);
}

TEST(MotorConstants, SayNothingWhereNothingCanBeSaid) {
  std::mt19937 random{4};
  EXPECT_FALSE(find_motor_constants({}).is_found);
  auto readings = readings_of({}, 0.49, 0.0, random);
  for (WeightReading& reading : readings) reading.with_weight = reading.without;
  EXPECT_FALSE(find_motor_constants(readings).is_found) << "the weight changed nothing";
  readings = readings_of({}, 0.49, 0.0, random);
  for (WeightReading& reading : readings) std::swap(reading.with_weight, reading.without);
  EXPECT_FALSE(find_motor_constants(readings).is_found) << "the weight pulled up";
  readings = readings_of({}, 0.49, 0.0, random);
  readings[1].with_weight.up *= 1.9;
  EXPECT_FALSE(find_motor_constants(readings).is_found) << "two places that contradict each other";
}

}  // namespace
}  // namespace ghostforce::motor_constants_test
