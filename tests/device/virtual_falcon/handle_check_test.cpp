// Motors and encoders that are not what the driver takes them for: found out before motors push against a hand, or, while
// they do, within 100 ms.
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

// Arms it in a hand that then leans in. No force but the check's own is ever asked for.
void expect_found_out(HeldFalcon& falcon) {
  ASSERT_TRUE(falcon.get_ready());
  falcon.ask_to_arm();
  EXPECT_LE(falcon.longest_drive(1.5), longest_s);
  EXPECT_EQ(falcon.motors().state, SafetyState::off);
  EXPECT_EQ(falcon.motors().reason, OffReason::calibration);
  EXPECT_EQ(falcon.motors().gain, 0.0);
  falcon.lead(HeldFalcon::deep_place, 0.5);
  falcon.run(1.0);
  EXPECT_EQ(falcon.link().motors(), MotorNumbers{});
}

TEST(HandleCheck, LetsRightMotorsComeOn) {
  for (const double stiffness : {20.0, 100.0, 500.0, 2000.0}) {
    HeldFalcon falcon({.stiffness = stiffness});
    ASSERT_TRUE(falcon.get_ready());
    EXPECT_TRUE(falcon.arm()) << entry_of(falcon.motors().reason).title;
  }
}

TEST(HandleCheck, NoticesMotorsThatAllPushTheOtherWay) {
  HeldFalcon falcon(with_motors({-1, -2, -3}));
  expect_found_out(falcon);
}

// A wall like a table: legs are checked along their whole way, whichever plane that lies in.
TEST(HandleCheck, WorksInAnotherPlane) {
  for (const LegNumbers& legs : {legs_in_order, LegNumbers{-1, 2, 3}, LegNumbers{1, -2, 3}, LegNumbers{1, 2, -3}}) {
    HeldFalcon::Options options = with_motors(legs);
    options.calibration.up_axis = FalconAxis::minus_z;
    HeldFalcon falcon(options);
    if (legs != legs_in_order) {
      expect_found_out(falcon);
      continue;
    }
    ASSERT_TRUE(falcon.get_ready());
    EXPECT_TRUE(falcon.arm()) << entry_of(falcon.motors().reason).title;
  }
}

TEST(HandleCheck, NoticesEachMotorThatPushesTheOtherWay) {
  for (const LegNumbers& legs : {LegNumbers{-1, 2, 3}, LegNumbers{1, -2, 3}, LegNumbers{1, 2, -3},
                                 LegNumbers{-1, -2, 3}, LegNumbers{1, -2, -3}, LegNumbers{-1, 2, -3}}) {
    HeldFalcon falcon(with_motors(legs));
    expect_found_out(falcon);
  }
}

TEST(HandleCheck, NoticesMotorsOfOtherLegs) {
  for (const LegNumbers& legs : {LegNumbers{2, 1, 3}, LegNumbers{3, 2, 1}, LegNumbers{1, 3, 2}, LegNumbers{2, 3, 1},
                                 LegNumbers{3, 1, 2}, LegNumbers{-2, -1, -3}, LegNumbers{2, -1, 3}}) {
    HeldFalcon falcon(with_motors(legs));
    expect_found_out(falcon);
  }
}

TEST(HandleCheck, NoticesEncodersOfOtherLegs) {
  HeldFalcon::Options options;
  options.arm.encoder_of_leg = {2, 1, 3};
  options.settings.wall_point = {0.2, -0.2};  // out of reach, wherever it takes the handle to be
  HeldFalcon falcon(options);
  ASSERT_TRUE(falcon.get_ready());
  falcon.ask_to_arm();
  falcon.run(1.5);
  EXPECT_EQ(falcon.motors().reason, OffReason::calibration);
}

TEST(HandleCheck, NoticesThatNothingMovesTheHandle) {
  HeldFalcon::Options options;
  options.arm.counts_per_newton_metre = 1e9;  // no power supply
  HeldFalcon falcon(options);
  ASSERT_TRUE(falcon.get_ready());
  falcon.ask_to_arm();
  EXPECT_TRUE(falcon.run_until(1.5, [&] { return falcon.motors().reason == OffReason::calibration; }));
  EXPECT_EQ(falcon.motors().gain, 0.0);
}

// The force of the check is weak, and no stronger than a person allows.
TEST(HandleCheck, PushesGently) {
  HeldFalcon falcon;
  falcon.command().safety.force_limit = 1.0;
  ASSERT_TRUE(falcon.get_ready());
  falcon.ask_to_arm();
  double greatest = 0.0;
  ASSERT_TRUE(falcon.run_until(5.0, [&] {
    greatest = std::max(greatest, glm::length(falcon.link().arm().force()));
    // Motors are driven with whole counts.
    EXPECT_LE(glm::length(falcon.link().arm().force()), falcon.motors().limit + 0.01);
    EXPECT_LE(glm::length(falcon.motors().sent), falcon.motors().limit + 1e-12);
    return falcon.motors().state == SafetyState::on;
  }));
  EXPECT_GT(greatest, 0.3);
  EXPECT_LT(greatest, MotorCheck::crest * MotorCheck::least_force);
}

// What is recorded as sent is what the motors make of it in the plane, the check's force included.
TEST(HandleCheck, IsPartOfWhatIsRecordedAsSent) {
  HeldFalcon falcon;
  ASSERT_TRUE(falcon.get_ready());
  falcon.ask_to_arm();
  double greatest = 0.0;
  Vector<2> before(0.0);
  falcon.run_until(5.0, [&] {
    // The arm feels for a tick what was sent in the one before.
    const Vector<3> force = falcon.link().arm().force();
    EXPECT_NEAR(force.x, before.x, 0.01);
    EXPECT_NEAR(force.y, before.y, 0.01);
    before = falcon.motors().sent;
    greatest = std::max(greatest, glm::length(before));
    return falcon.motors().gain > 0.0;
  });
  EXPECT_GT(greatest, 0.3);
}

TEST(HandleCheck, NoticesEncodersThatFreezeWhileAForceStands) {
  for (const double stiffness : {50.0, 100.0, 500.0, 2000.0}) {
    SCOPED_TRACE(stiffness);
    for (int after_ms = 0; after_ms < 100; after_ms += 21) {
      HeldFalcon falcon({.stiffness = stiffness});
      ASSERT_TRUE(falcon.get_ready());
      ASSERT_TRUE(falcon.arm());
      falcon.lead(HeldFalcon::deep_place, 0.5);
      falcon.run(1.5 + 0.001 * after_ms);
      ASSERT_GT(glm::length(falcon.motors().sent), 0.5);
      falcon.inject("frozen-encoders");
      EXPECT_LE(falcon.longest_drive(1.0), longest_s) << after_ms;
      EXPECT_EQ(falcon.motors().reason, OffReason::calibration);
    }
  }
}

// Also on the way in, and on the way out.
TEST(HandleCheck, NoticesEncodersThatFreezeWhileTheHandleMoves) {
  for (const double after_s : {0.3, 0.4, 0.6}) {
    HeldFalcon falcon;
    ASSERT_TRUE(falcon.get_ready());
    ASSERT_TRUE(falcon.arm());
    falcon.lead(HeldFalcon::deep_place, 0.4);
    falcon.run(after_s);
    if (after_s > 0.5) falcon.lead(HeldFalcon::free_place, 0.4);
    falcon.run(0.05);
    ASSERT_GT(glm::length(falcon.motors().sent), 0.5) << after_s;
    falcon.inject("frozen-encoders");
    EXPECT_LE(falcon.longest_drive(1.0), longest_s) << after_s;
    EXPECT_EQ(falcon.motors().reason, OffReason::calibration) << after_s;
  }
}

// A hand that rests in the wall is asked again and again. It is moved by about a tenth of a millimetre.
TEST(HandleCheck, LeavesARestingHandWhereItIs) {
  for (const double stiffness : {50.0, 100.0, 500.0, 2000.0}) {
    SCOPED_TRACE(stiffness);
    HeldFalcon falcon({.stiffness = stiffness});
    ASSERT_TRUE(falcon.get_ready());
    ASSERT_TRUE(falcon.arm());
    falcon.lead(HeldFalcon::deep_place, 0.5);
    falcon.run(2.5);
    const Vector<3> rest = falcon.link().arm().position();
    double way = 0.0;
    for (int i = 0; i < 5000; ++i) {
      falcon.step();
      way += glm::length(falcon.link().arm().position() - rest);
    }
    EXPECT_EQ(falcon.motors().state, SafetyState::on);
    EXPECT_LT(way / 5000, 0.15e-3);
  }
}

TEST(HandleCheck, IsDoneAnewEachTimeThatMotorsComeOn) {
  HeldFalcon falcon;
  ASSERT_TRUE(falcon.get_ready());
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(falcon.arm());
    falcon.disarm();
    ASSERT_TRUE(falcon.run_until(1.0, [&] { return falcon.motors().state == SafetyState::off; }));
    falcon.ask_to_arm();
    ASSERT_TRUE(falcon.run_until(2.0, [&] { return falcon.motors().state == SafetyState::ramp; }));
    falcon.run(0.1);
    EXPECT_EQ(falcon.motors().gain, 0.0);
    ASSERT_TRUE(falcon.run_until(2.0, [&] { return falcon.motors().state == SafetyState::on; }));
    falcon.disarm();
    falcon.run(1.0);
  }
}

}  // namespace
}  // namespace ghostforce::handle_check_test
