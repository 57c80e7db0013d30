// Motors and encoders that are not what the driver takes them for: found out before motors push against a hand, or,
// while they do, before the handle has gone far. No force but the check's own is asked for until all is well.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/device/haply/held_haply.h"

namespace ghostforce::haply_check_test {
namespace {

constexpr double longest_drive_ms = 100.0;  // as with the Falcon

void print(const char* what, const PushWatch& watch, HeldHaply& haply) {
  if (std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") == nullptr) return;
  std::printf("%-44s %-11s pushing until %7.1f ms, up to %.2f N, handle went %.2f mm\n", what,
              haply.motors().state == SafetyState::off ? std::string(haply.reason()).c_str() : "on", watch.ms_pushing(),
              watch.greatest_force(), mm_per_m * watch.farthest());
}

// Asks to arm; nothing but the check pushes, gently, and it ends with the reason that it has.
void expect_found_out(HeldHaply& haply, const std::string& what, double greatest_force = 2.3) {
  SCOPED_TRACE(what);
  haply.ask_to_arm();
  ASSERT_TRUE(haply.run_until(1.0, [&] { return haply.motors().state == SafetyState::ramp; }));
  PushWatch watch(haply);
  for (int i = 0; i < 8000 && haply.motors().state != SafetyState::off; ++i) {
    haply.step();
    ASSERT_EQ(haply.motors().gain, 0.0) << "the wall must not push yet";
  }
  print(what.c_str(), watch, haply);
  EXPECT_EQ(haply.motors().state, SafetyState::off);
  EXPECT_EQ(haply.motors().reason, OffReason::calibration) << haply.reason();
  EXPECT_LT(watch.greatest_force(), greatest_force);
  EXPECT_LT(watch.farthest(), 20e-3);
  haply.lead(HeldHaply::deep_place, 0.5);
  haply.run(1.0);
  EXPECT_FALSE(haply.pushes());
}

TEST(HaplyCheck, LetsRightMotorsComeOn) {
  for (const HaplyVariant& variant : haply_variant_catalog()) {
    for (const double stiffness : {20.0, 100.0, 300.0, 1000.0}) {
      for (const Vector<2> place : {HeldHaply::free_place, Vector<2>(0.0, 0.02), Vector<2>(-0.02, 0.0)}) {
        SCOPED_TRACE(std::string(variant.name) + ' ' + std::to_string(stiffness) + ' ' + std::to_string(place.x));
        HeldHaply::Options options;
        options.device.variant = variant.name;
        options.device.hand.stiffness = stiffness;
        options.calibration = variant.calibration;
        HeldHaply haply(options);
        ASSERT_TRUE(haply.get_ready());
        haply.lead(place, 0.3);
        haply.run(1.0);
        EXPECT_TRUE(haply.arm()) << haply.reason() << name_of(haply.motors().state);
      }
    }
  }
}

TEST(HaplyCheck, NoticesMotorsThatPushTheOtherWay) {
  for (const char* names : {"1", "2", "12"}) {
    HeldHaply haply;
    ASSERT_TRUE(haply.get_ready());
    InjectedHaplyFault wrong;
    for (const char* name = names; *name != 0; ++name) {
      find_injected_haply_fault(*name == '1' ? "wrong-sign-1" : "wrong-sign-2")->add(wrong);
    }
    haply.board().inject(wrong);
    expect_found_out(haply, std::string("wrong sign of motor ") + names, 0.25);
  }
}

// A dev kit with the wiring of an M3, and the calibration of one.
TEST(HaplyCheck, NoticesADevKitsInvertedPorts) {
  for (const HaplyVariant& variant : haply_variant_catalog()) {
    HeldHaply::Options options;
    options.device.board.kind = HaplyBoard::Kind::dev_kit;
    options.device.variant = variant.name;
    options.calibration = variant.calibration;
    HeldHaply haply(options);
    ASSERT_TRUE(haply.get_ready());
    expect_found_out(haply, "dev kit taken for an M3, " + std::string(variant.name), 0.25);
  }
}

TEST(HaplyCheck, NoticesMotorsOfTheOtherArm) {
  for (const bool is_reversed : {false, true}) {
    HeldHaply::Options options;
    std::swap(options.calibration.arms[0].motor_port, options.calibration.arms[1].motor_port);
    for (HaplyArm& arm : options.calibration.arms) arm.is_motor_reversed = is_reversed;
    HeldHaply haply(options);
    ASSERT_TRUE(haply.get_ready());
    expect_found_out(haply, is_reversed ? "motors swapped and reversed" : "motors swapped");
  }
}

TEST(HaplyCheck, NoticesEncodersThatAreFrozenBeforeIt) {
  for (const char* name : {"frozen-encoder", "frozen-encoders"}) {
    HeldHaply haply;
    ASSERT_TRUE(haply.get_ready());
    haply.inject(name);
    expect_found_out(haply, name);
  }
}

TEST(HaplyCheck, NoticesThatNothingMovesTheHandle) {
  HeldHaply::Options options;
  options.device.full_torques = Vector<2>(1e-6);
  HeldHaply haply(options);
  ASSERT_TRUE(haply.get_ready());
  expect_found_out(haply, "no supply of the motors");
}

// The check is all that there is before the ramp, and docs/haply.md says with how much it pushes. What comes before it,
// and pushes less, is in haply_direction_test.cpp.
TEST(HaplyCheck, PushesWithNoMoreThanTheGuideSays) {
  for (const double stiffness : {20.0, 100.0, 300.0, 1000.0}) {
    SCOPED_TRACE(stiffness);
    HeldHaply::Options options;
    options.device.hand.stiffness = stiffness;
    HeldHaply haply(options);
    ASSERT_TRUE(haply.get_ready());
    haply.ask_to_arm();
    PushWatch watch(haply);
    ASSERT_TRUE(haply.run_until(6.0, [&] { return haply.motors().gain > 0.0; })) << haply.reason();
    print(("the check, all being well, k_u " + std::to_string(stiffness)).c_str(), watch, haply);
    EXPECT_GT(watch.greatest_force(), 0.5);
    EXPECT_LT(watch.greatest_force(), 2.1);
  }
}

// The motor that pushes is turned round while it does, as no motor is. The driver does not notice: what a hand of this
// stiffness feels of it is what one motor has.
TEST(HaplyCheck, AMotorThatTurnsRoundWhileItPushesHasNoMoreThanItsForce) {
  HeldHaply haply;
  ASSERT_TRUE(haply.press());
  haply.inject("wrong-sign-2");
  PushWatch watch(haply);
  haply.run(2.0);
  print("wrong sign while it pushes", watch, haply);
  EXPECT_LT(watch.greatest_force(), 2.3);
  EXPECT_LT(watch.farthest(), 2.0 * 2.3 / 100.0);
  haply.disarm();
  haply.run(0.5);
  EXPECT_FALSE(haply.pushes());
  // A handle that leaves so fast may have cost an encoder its count: then the zero pose comes first.
  if (haply.haply().state == HaplyState::zero_pose) {
    ASSERT_TRUE(haply.get_ready());
  }
  haply.lead(HeldHaply::free_place, 0.3);
  haply.run(1.0);
  expect_found_out(haply, "and when it is to come on again");
}

TEST(HaplyCheck, NoticesEncodersThatFreezeWhileAForceStands) {
  for (const double stiffness : {50.0, 100.0, 500.0, 2000.0}) {
    for (int after_ms = 0; after_ms < 100; after_ms += 21) {
      SCOPED_TRACE(std::to_string(stiffness) + ' ' + std::to_string(after_ms));
      HeldHaply::Options options;
      options.device.hand.stiffness = stiffness;
      HeldHaply haply(options);
      ASSERT_TRUE(haply.press(stiffness < 100.0 ? Vector<2>(0.02, -0.02) : Vector<2>(0.011, -0.011)));
      haply.run(0.001 * after_ms);
      haply.inject("frozen-encoders");
      PushWatch watch(haply);
      haply.run(1.0);
      if (after_ms == 0) print(("both encoders freeze, k_u " + std::to_string(stiffness)).c_str(), watch, haply);
      EXPECT_LE(watch.ms_pushing(), longest_drive_ms);
      EXPECT_EQ(haply.motors().reason, OffReason::calibration);
    }
  }
}

// One encoder: its arm's place is a guess from then on. Wherever the hand goes, it is noticed before that guess is
// wrong by much, or before the other arm has turned far.
TEST(HaplyCheck, NoticesOneEncoderThatFreezesInAMovingHand) {
  for (const std::uint8_t frozen : {std::uint8_t{1}, std::uint8_t{2}}) {
    for (const Vector<2> way : {Vector<2>(0.01, 0.01), Vector<2>(-0.01, 0.01), Vector<2>(0.01, -0.01),
                                Vector<2>(0.015, 0.0), Vector<2>(0.0, -0.015)}) {
      SCOPED_TRACE(std::to_string(frozen) + ' ' + std::to_string(way.x) + ' ' + std::to_string(way.y));
      HeldHaply haply;
      ASSERT_TRUE(haply.press());
      InjectedHaplyFault wrong;
      wrong.frozen_encoders = frozen;
      haply.board().inject(wrong);
      PushWatch watch(haply);
      double misplaced = 0.0;
      haply.lead(HeldHaply::deep_place + way, 0.5);
      for (int i = 0; i < 2000; ++i) {
        haply.step();
        if (haply.motors().state != SafetyState::off) misplaced = std::max(misplaced, haply.misplaced());
      }
      print(("encoder " + std::to_string(frozen) + " freezes, handle misplaced by " +
             std::to_string(mm_per_m * misplaced).substr(0, 4) + " mm")
                .c_str(),
            watch, haply);
      // In the end the question itself moves the handle, which nobody sees: by 1.5 N against a hand of 100 N/m.
      EXPECT_LT(misplaced, 15e-3);
      // The arm without a force is asked by its own motor, which comes on top.
      EXPECT_LT(watch.greatest_force(), frozen == 1 ? 3.5 : 2.3);
      // Where the frozen arm hardly turns nothing is wrong, and nothing can be seen. Nor can it where only the arm turns
      // whose motor does not push: nobody asks it.
      const bool turns_alone = frozen == 1 && way == Vector<2>(0.01, 0.01);
      EXPECT_TRUE(haply.motors().state == SafetyState::off || misplaced < 6e-3 || turns_alone);
    }
  }
}

// Half the angles, or twice: signs are right, so that no check of signs finds it. Wherever the handle is, no more than
// a motor's force acts, the wall is elsewhere, and the force points less than a right angle away from where it should.
TEST(HaplyCheck, WrongCountsOfATurnAreNoPositiveFeedback) {
  for (const double factor : {0.5, 2.0}) {
    for (const std::size_t motor : {0U, 1U}) {
      SCOPED_TRACE(std::to_string(factor) + ' ' + std::to_string(motor));
      HeldHaply::Options options;
      options.device.counts_per_turn = Vector<2>(factor * 4880.0);
      options.motor = motor;
      HeldHaply haply(options);
      if (!haply.get_ready() || !haply.arm()) {
        if (std::getenv("GHOSTFORCE_PRINT_HAPLY_FAULTS") != nullptr) {
          std::printf("counts times %.1f, motor %zu: not armed (%s), handle misplaced by %.1f mm\n", factor, motor,
                      std::string(haply.reason()).c_str(), mm_per_m * haply.misplaced());
        }
        EXPECT_FALSE(haply.pushes() && haply.motors().gain > 0.0);
        continue;
      }
      PushWatch watch(haply);
      double misplaced = 0.0;
      double least_cosine = 1.0;
      haply.lead(HeldHaply::deep_place, 0.5);
      for (int i = 0; i < 2000; ++i) {
        const Vector<2> wanted = haply.motors().sent;
        haply.step();
        const Vector<2> got = -haply.truth().force;
        misplaced = std::max(misplaced, haply.misplaced());
        if (glm::length(wanted) < 0.3 || glm::length(got) < 0.3) continue;
        least_cosine = std::min(least_cosine, glm::dot(wanted, got) / glm::length(wanted) / glm::length(got));
      }
      print(("counts times " + std::to_string(factor).substr(0, 3) + ", misplaced " +
             std::to_string(mm_per_m * misplaced).substr(0, 4) + " mm, cosine " +
             std::to_string(least_cosine).substr(0, 5))
                .c_str(),
            watch, haply);
      EXPECT_GT(least_cosine, 0.0);
      EXPECT_LT(watch.greatest_force(), 3.0);
    }
  }
}

TEST(HaplyCheck, AWrongZeroPoseIsNoPositiveFeedback) {
  for (const std::size_t motor : {0U, 1U}) {
    HeldHaply::Options options;
    options.motor = motor;
    HeldHaply haply(options);
    haply.inject("wrong-zero-pose");
    ASSERT_TRUE(haply.get_ready());
    ASSERT_TRUE(haply.arm()) << haply.reason();
    PushWatch watch(haply);
    haply.lead({0.015, -0.015}, 0.5);
    double misplaced = 0.0;
    double least_cosine = 1.0;
    for (int i = 0; i < 1500; ++i) {
      const Vector<2> wanted = haply.motors().sent;
      haply.step();
      misplaced = std::max(misplaced, haply.misplaced());
      const Vector<2> got = -haply.truth().force;
      if (glm::length(wanted) < 0.3 || glm::length(got) < 0.3) continue;
      least_cosine = std::min(least_cosine, glm::dot(wanted, got) / glm::length(wanted) / glm::length(got));
    }
    print(("zero pose wrong by 8°, misplaced " + std::to_string(mm_per_m * misplaced).substr(0, 4) + " mm, cosine " +
           std::to_string(least_cosine).substr(0, 5))
              .c_str(),
          watch, haply);
    EXPECT_GT(least_cosine, 0.95) << "8° of each arm turn a line by no more than that";
    EXPECT_LT(misplaced, 20e-3);
  }
}

// A handle that goes along the circle about the other elbow turns one arm alone. Nothing is wrong with that.
TEST(HaplyCheck, AHandThatTurnsOneArmAloneIsNoFrozenEncoder) {
  for (const std::size_t turned : {0U, 1U}) {
    SCOPED_TRACE(turned);
    HeldHaply haply;
    haply.command().settings.wall_point = {0.2, -0.2};  // out of the way
    ++haply.command().settings_generation;
    ASSERT_TRUE(haply.get_ready());
    ASSERT_TRUE(haply.arm()) << haply.reason();
    const Vector<2> angles = haply.truth().angles;
    const ArmsGeometry& geometry = haply.board().bench().variant().geometry;
    for (int degree = 0; degree <= 12; ++degree) {
      Vector<2> turn = angles;
      turn[static_cast<glm::length_t>(turned)] += degree * radians_per_degree;
      haply.lead(haply.plane().in_scene(geometry.place(turn)->handle), 0.05);
      haply.run(0.05);
    }
    haply.run(0.3);
    EXPECT_EQ(haply.motors().state, SafetyState::on) << haply.reason();
  }
}

// Near a singular pose the motors get less than is asked for, or nothing. That no encoder answers then proves nothing.
TEST(HaplyCheck, WhereNothingPushesNoEncoderIsFrozen) {
  HeldHaply::Options options;
  options.settings.wall_normal_angle = 90.0 * radians_per_degree;
  options.settings.wall_point = {0.0, -0.035};
  options.settings.stiffnesses.k_r = options.settings.stiffnesses.k_t = 100.0;
  options.device.hand.stiffness = 400.0;
  options.motor = 0;
  HeldHaply haply(options);
  ASSERT_TRUE(haply.get_ready());
  ASSERT_TRUE(haply.arm()) << haply.reason();
  haply.lead({0.0, -0.080}, 1.5);
  haply.run(3.0);
  EXPECT_LT(haply.haply().workspace_share, 0.1);
  EXPECT_EQ(haply.motors().state, SafetyState::on) << haply.reason();
}

// A person is asked again and again whether the encoders count, and is moved by no more than a tenth of a millimetre.
TEST(HaplyCheck, LeavesARestingHandWhereItIs) {
  for (const double stiffness : {50.0, 100.0, 500.0}) {
    SCOPED_TRACE(stiffness);
    HeldHaply::Options options;
    options.device.hand.stiffness = stiffness;
    HeldHaply haply(options);
    ASSERT_TRUE(haply.press(stiffness < 100.0 ? Vector<2>(0.02, -0.02) : HeldHaply::deep_place));
    haply.run(1.0);
    const Vector<2> rest = haply.truth().handle;
    double way = 0.0;
    for (int i = 0; i < 3000; ++i) {
      haply.step();
      way += glm::length(haply.truth().handle - rest);
    }
    EXPECT_EQ(haply.motors().state, SafetyState::on) << haply.reason();
    // A step of an encoder is 116 µm at the handle.
    EXPECT_LT(way / 3000, 0.25e-3);
  }
}

}  // namespace
}  // namespace ghostforce::haply_check_test
