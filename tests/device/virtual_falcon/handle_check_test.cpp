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

TEST(HandleCheck, Disturbs) {
  for (const double stiffness : {50.0, 100.0, 500.0, 2000.0}) {
    HeldFalcon::Options options;
    options.stiffness = stiffness;
    HeldFalcon falcon(options);
    ASSERT_TRUE(falcon.get_ready());
    Vector<3> c0 = falcon.link().arm().position();
    double worst0 = 0.0;
    falcon.ask_to_arm();
    falcon.run_until(5.0, [&] { worst0 = std::max(worst0, glm::length(falcon.link().arm().position() - c0)); return falcon.motors().state == SafetyState::on; });
    falcon.lead(HeldFalcon::deep_place, 0.5);
    falcon.run(2.5);
    Vector<3> mean(0.0);
    const Vector<3> c = falcon.link().arm().position();
    double worst = 0.0, sum = 0.0;
    for (int i = 0; i < 2000; ++i) {
      falcon.step();
      const double d = glm::length(falcon.link().arm().position() - c);
      worst = std::max(worst, d);
      sum += d;
      mean += (falcon.link().arm().position() - c) / 2000.0;
    }
    std::printf("k %g: arming %.0f um, worst %.0f um, mean length %.0f um, mean %.0f %.0f %.0f um\n", stiffness, 1e6*worst0, 1e6 * worst, 1e6 * sum / 2000, 1e6 * mean.x, 1e6*mean.y, 1e6*mean.z);
  }
}

}  // namespace
}  // namespace ghostforce::handle_check_test
