// Motors and encoders that are not what the driver takes them for: found out before motors push, or within 100 ms.
#include <gtest/gtest.h>

#include "tests/device/virtual_falcon/held_falcon.h"

namespace ghostforce::handle_check_test {
namespace {

constexpr double longest_s = 0.100;

HeldFalcon::Options with_motors(const LegNumbers& motor_of_leg) {
  HeldFalcon::Options options;
  options.calibration.motor_of_leg = motor_of_leg;
  return options;
}

TEST(HandleCheck, RightMotorsComeOn) {
  HeldFalcon falcon;
  ASSERT_TRUE(falcon.get_ready());
  EXPECT_TRUE(falcon.arm()) << entry_of(falcon.motors().reason).title;
}

TEST(HandleCheck, MotorsThatAllPushTheOtherWayAreFoundOut) {
  HeldFalcon falcon(with_motors({-1, -2, -3}));
  ASSERT_TRUE(falcon.get_ready());
  falcon.ask_to_arm();
  EXPECT_LE(falcon.driven_for(3.0), longest_s);
  EXPECT_EQ(falcon.motors().state, SafetyState::off);
  EXPECT_EQ(falcon.motors().reason, OffReason::calibration);
}

TEST(HandleCheck, AMotorThatPushesTheOtherWayIsFoundOut) {
  for (const LegNumbers& legs : {LegNumbers{-1, 2, 3}, LegNumbers{1, -2, 3}, LegNumbers{1, 2, -3}}) {
    HeldFalcon falcon(with_motors(legs));
    ASSERT_TRUE(falcon.get_ready());
    falcon.ask_to_arm();
    std::printf("driven %f\n", falcon.driven_for(3.0));
    EXPECT_EQ(falcon.motors().state, SafetyState::off);
    EXPECT_EQ(falcon.motors().reason, OffReason::calibration);
  }
}

TEST(HandleCheck, MotorsOfOtherLegsAreFoundOut) {
  for (const LegNumbers& legs : {LegNumbers{2, 1, 3}, LegNumbers{3, 2, 1}, LegNumbers{1, 3, 2}, LegNumbers{2, 3, 1}, LegNumbers{3, 1, 2}}) {
    HeldFalcon falcon(with_motors(legs));
    ASSERT_TRUE(falcon.get_ready());
    falcon.ask_to_arm();
    falcon.run(4.0);
    EXPECT_EQ(falcon.motors().state, SafetyState::off);
    EXPECT_EQ(falcon.motors().reason, OffReason::calibration);
  }
}

TEST(HandleCheck, EncodersThatFreezeWhileAForceStandsEndIt) {
  for (const double stiffness : {50.0, 100.0, 500.0, 2000.0}) {
  HeldFalcon::Options options;
  options.stiffness = stiffness;
  HeldFalcon falcon(options);
  ASSERT_TRUE(falcon.get_ready());
  ASSERT_TRUE(falcon.arm()) << stiffness;
  falcon.lead(HeldFalcon::deep_place, 0.5);
  falcon.run(1.5);
  ASSERT_EQ(falcon.motors().state, SafetyState::on) << entry_of(falcon.motors().reason).title << stiffness;
  ASSERT_GT(glm::length(falcon.motors().sent), 0.5);
  falcon.inject("frozen-encoders");
  const double d = falcon.driven_for(3.0);
  std::printf("k %g: %f\n", stiffness, d);
  EXPECT_LE(d, longest_s);
  EXPECT_EQ(falcon.motors().reason, OffReason::calibration);
  }
}

}  // namespace
}  // namespace ghostforce::handle_check_test
