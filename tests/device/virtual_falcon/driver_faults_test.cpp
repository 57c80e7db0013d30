// What goes wrong while the motors push, and how the driver comes back: a reply that is lost or wrong is got over, all
// else ends the force, and what goes away again needs no restart.
#include <gtest/gtest.h>

#include <string>

#include "tests/device/virtual_falcon/rehearsal.h"

namespace ghostforce::driver_faults_test {
namespace {

InjectedFault named(const std::string& name) {
  InjectedFault wrong;
  find_injected_fault(name)->add(wrong);
  return wrong;
}

// Armed, and the hand leans into the wall.
class PushingFalcon : public testing::Test {
 protected:
  void SetUp() override {
    rehearsal.turn_on();
    lean_in();
  }
  void lean_in() {
    rehearsal.input().move_to({0.02, -0.02}, 0.5);
    rehearsal.run(1.5);
    ASSERT_EQ(rehearsal.motors().state, SafetyState::on);
    ASSERT_NE(on_the_device(), MotorNumbers{});
  }
  MotorNumbers on_the_device() { return rehearsal.input().link().motors(); }

  // Milliseconds until nothing drives the motors any more; -1: they are still driven after `longest_s`.
  int ms_to_zero(double longest_s) {
    for (int ms = 0; ms < longest_s * 1000.0; ++ms) {
      if (on_the_device() == MotorNumbers{}) return ms;
      rehearsal.step();
    }
    return -1;
  }

  Rehearsal rehearsal;
};

// A lab has a plug that crackles now and then: the force stays, and nobody has to arm again.
TEST_F(PushingFalcon, OneBadReplyIsGotOver) {
  for (const char* name : {"lost-reply", "malformed-reply", "wrong-reply", "encoder-glitch", "line-noise"}) {
    for (int time = 0; time < 5; ++time) {
      rehearsal.input().inject(named(name));
      rehearsal.run(0.2);
      ASSERT_EQ(rehearsal.motors().state, SafetyState::on) << name << entry_of(rehearsal.motors().reason).title;
      rehearsal.input().inject({});
      rehearsal.run(0.05);
    }
    // Nor was a position believed in which the arms have never been.
    EXPECT_LT(glm::length(rehearsal.motors().handle - rehearsal.tip()), 1e-3) << name;
  }
  EXPECT_GE(rehearsal.falcon().lost_exchanges, 10U);
  EXPECT_EQ(rehearsal.falcon().faults, 0U);
}

// However many are lost, the force that is on was asked for less than 20 ms ago.
TEST_F(PushingFalcon, NoReplyAtAllIsNoForceSoon) {
  for (const char* name : {"silence", "mute"}) {
    SCOPED_TRACE(name);
    rehearsal.input().inject(named(name));
    const int ms = ms_to_zero(1.0);
    // A device that takes nothing in cannot be told.
    if (std::string(name) == "mute") {
      EXPECT_GE(ms, 0);
      EXPECT_LE(ms, 25);
    }
    rehearsal.run(0.1);
    EXPECT_EQ(rehearsal.motors().state, SafetyState::off);
    rehearsal.input().inject({});
    ASSERT_TRUE(rehearsal.run_until_state(FalconState::idle, 60.0));
    EXPECT_EQ(on_the_device(), MotorNumbers{});
    rehearsal.turn_on();
    lean_in();
  }
}

// The device is well and its encoders are not, for longer than a second: this ends when it ends.
TEST_F(PushingFalcon, ImpossibleEncodersEndTheForceAndThenTheFault) {
  const std::uint64_t faults = rehearsal.falcon().faults;
  rehearsal.input().inject(named("impossible-encoders"));
  const int ms = ms_to_zero(1.0);
  EXPECT_GE(ms, 0);
  EXPECT_LE(ms, 25);
  rehearsal.run(2.0);
  EXPECT_EQ(rehearsal.falcon().state, FalconState::fault);
  EXPECT_EQ(rehearsal.falcon().fault, FalconFault::kinematics);
  EXPECT_EQ(rehearsal.motors().state, SafetyState::off);
  EXPECT_EQ(rehearsal.falcon().faults, faults + 1) << "one fault, told once";
  rehearsal.input().inject({});
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::idle, 1.0));
  EXPECT_EQ(rehearsal.falcon().fault, FalconFault::none);
  EXPECT_EQ(rehearsal.motors().state, SafetyState::off) << "only a person arms";
  rehearsal.turn_on();
}

TEST_F(PushingFalcon, ImpossibleEncodersAreForgottenWithThePlug) {
  rehearsal.input().inject(named("impossible-encoders"));
  rehearsal.run(2.0);
  rehearsal.input().inject(named("unplugged"));
  rehearsal.run(1.0);
  EXPECT_EQ(rehearsal.falcon().fault, FalconFault::unplugged);
  rehearsal.input().inject({});
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::idle, 60.0));
  rehearsal.turn_on();
}

TEST_F(PushingFalcon, AForgottenHomeEndsTheForceAndIsFoundAgain) {
  rehearsal.input().inject(named("forgets-home"));
  const int ms = ms_to_zero(1.0);
  EXPECT_GE(ms, 0);
  EXPECT_LE(ms, 25);
  rehearsal.run(0.1);
  EXPECT_EQ(rehearsal.motors().reason, OffReason::not_homed);
  rehearsal.input().inject({});
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::idle, 60.0));
  rehearsal.turn_on();
}

// Replies that come twice are no news, and make no reply look fresher.
TEST_F(PushingFalcon, DuplicatedRepliesChangeNothing) {
  rehearsal.input().inject(named("duplicated-replies"));
  rehearsal.run(2.0);
  EXPECT_EQ(rehearsal.motors().state, SafetyState::on) << entry_of(rehearsal.motors().reason).title;
  EXPECT_LT(glm::length(rehearsal.motors().handle - rehearsal.tip()), 1e-3);
}

// It was told to stop and cannot have heard: that is said, until it has answered again.
TEST_F(PushingFalcon, SaysThatItMayStillPush) {
  EXPECT_FALSE(rehearsal.falcon().may_still_push);
  rehearsal.input().inject(named("unplugged"));
  rehearsal.run(0.5);
  EXPECT_TRUE(rehearsal.falcon().may_still_push);
  rehearsal.input().inject({});
  ASSERT_TRUE(rehearsal.run_until_state(FalconState::idle, 60.0));
  EXPECT_FALSE(rehearsal.falcon().may_still_push);
}

}  // namespace
}  // namespace ghostforce::driver_faults_test
