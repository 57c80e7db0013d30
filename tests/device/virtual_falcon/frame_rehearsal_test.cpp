// A rehearsal in a program without threads: servo, driver and virtual Falcon are stepped once a frame, and each frame
// brings all the ticks that are due at once. By a clock of the test's.
#include <algorithm>

#include <gtest/gtest.h>

#include "tests/device/virtual_falcon/rehearsal.h"

namespace ghostforce::frame_rehearsal_test {
namespace {

class FrameRehearsal : public testing::TestWithParam<int> {
 protected:
  Rehearsal rehearsal{{}, {}, GetParam() * 0.001};
  double longest_sent() {
    double longest = 0.0;
    for (Sample sample; rehearsal.servo().take_sample(sample);) longest = std::max(longest, glm::length(sample.sent));
    return longest;
  }
};

TEST_P(FrameRehearsal, HomesArmsAndPushes) {
  rehearsal.turn_on();
  EXPECT_GT(rehearsal.falcon().exchange_hz, 900.0);
  EXPECT_LT(rehearsal.falcon().worst_exchange_s, 0.005);
  longest_sent();
  const std::uint64_t late_ticks = rehearsal.report().loop.late_ticks;  // of a device that did not answer yet
  rehearsal.input().move_to({0.01, -0.01}, 0.5);
  rehearsal.run(2.0);
  EXPECT_EQ(rehearsal.motors().state, SafetyState::on) << entry_of(rehearsal.motors().reason).title;
  EXPECT_GT(glm::length(rehearsal.motors().sent), 0.5);
  EXPECT_LT(longest_sent(), 6.0);
  EXPECT_EQ(rehearsal.report().loop.late_ticks, late_ticks);
  EXPECT_NEAR(rehearsal.report().loop.rate_hz, 1000.0, 50.0);
  EXPECT_FALSE(rehearsal.report().diverged);
}

// The same place, however long the frames are.
TEST_P(FrameRehearsal, ComesToRestWhereItDoesByHand) {
  Rehearsal by_hand;
  for (Rehearsal* const each : {&by_hand, &rehearsal}) {
    each->turn_on();
    each->input().move_to({0.01, -0.01}, 0.5);
    each->run(3.0);
    ASSERT_EQ(each->motors().state, SafetyState::on);
  }
  EXPECT_NEAR(glm::length(rehearsal.tip() - by_hand.tip()), 0.0, 0.0005);
  EXPECT_NEAR(glm::length(rehearsal.motors().sent - by_hand.motors().sent), 0.0, 0.3);
}

// Nothing has moved meanwhile, and nobody was there who could have felt it.
TEST_P(FrameRehearsal, GoesOnAfterThePageWasHidden) {
  rehearsal.turn_on();
  const Vector<2> before = rehearsal.tip();
  rehearsal.pass(3600.0);
  rehearsal.run(1.0);
  EXPECT_EQ(rehearsal.motors().state, SafetyState::on) << entry_of(rehearsal.motors().reason).title;
  EXPECT_NEAR(glm::length(rehearsal.tip() - before), 0.0, 0.001);
}

// Frames go on, but the window does not say so: it hangs.
TEST_P(FrameRehearsal, StillNoticesAWindowThatStalls) {
  rehearsal.turn_on();
  for (double t = 0.0; t < 1.5; t += GetParam() * 0.001) {
    rehearsal.pass(GetParam() * 0.001);
    rehearsal.servo().step_to(rehearsal.now_ns());
  }
  EXPECT_EQ(rehearsal.motors().reason, OffReason::window_stalled);
}

TEST_P(FrameRehearsal, LeavesTheMotorsOffAtTheEnd) {
  rehearsal.turn_on();
  rehearsal.input().move_to({0.01, -0.01}, 0.5);
  rehearsal.run(2.0);
  rehearsal.servo().shut_down();
  EXPECT_EQ(rehearsal.input().link().motors(), MotorNumbers{});
}

INSTANTIATE_TEST_SUITE_P(OfSoManyMilliseconds, FrameRehearsal, testing::Values(1, 4, 16, 33, 100, 150));

}  // namespace
}  // namespace ghostforce::frame_rehearsal_test
