// The simulated hand follows its plan, homes a device that asks for it, and takes new plans at any time.
#include "device/virtual_falcon/hand.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "device/falcon/frame.h"

namespace ghostforce::hand_test {
namespace {

constexpr std::int64_t ms = 1'000'000;

TEST(SimulatedHand, RestsInTheMiddleUntilSomethingIsPlanned) {
  SimulatedHand hand(HandPlan{}, 0);
  hand.advance(500 * ms, true);
  EXPECT_EQ(hand.goal(), HandPlan::centre);
  EXPECT_EQ(hand.stiffness(), 100.0);
  EXPECT_EQ(hand.buttons(), 0);
  EXPECT_FALSE(hand.is_homing());
}

TEST(SimulatedHand, GoesFromWaypointToWaypointWithItsButtons) {
  SimulatedHand hand(HandPlan{}, 0);
  HandPlan plan = hand_at({0.01, 0.0, 0.125}, 1.0);
  plan.add({.time = 2.0, .goal = {0.01, 0.02, 0.125}, .buttons = ReplyFrame::button_centre});
  plan.add({.time = 3.0, .goal = {0.01, 0.02, 0.125}});
  hand.follow(plan);
  hand.advance(100 * ms, false);
  EXPECT_EQ(hand.goal(), HandPlan::centre);
  hand.advance(600 * ms, false);
  EXPECT_NEAR(hand.goal().x, 0.005, 1e-12);
  hand.advance(1600 * ms, false);
  EXPECT_NEAR(hand.goal().y, 0.01, 1e-12);
  EXPECT_EQ(hand.buttons(), 0);
  hand.advance(2500 * ms, false);
  EXPECT_EQ(hand.goal(), Vector<3>(0.01, 0.02, 0.125));
  EXPECT_EQ(hand.buttons(), ReplyFrame::button_centre);
  hand.advance(9000 * ms, false);
  EXPECT_EQ(hand.goal(), Vector<3>(0.01, 0.02, 0.125));
  EXPECT_EQ(hand.buttons(), 0);
}

TEST(SimulatedHand, ANewPlanBeginsWhereTheGoalIs) {
  SimulatedHand hand(hand_at({0.02, 0.0, 0.125}, 1.0), 0);
  hand.advance(2000 * ms, false);
  hand.follow(hand_at({0.02, 0.01, 0.125}, 0.1));
  hand.advance(2000 * ms, false);
  EXPECT_EQ(hand.goal(), Vector<3>(0.02, 0.0, 0.125));
  hand.advance(2050 * ms, false);
  EXPECT_LT(glm::length(hand.goal() - Vector<3>{0.02, 0.005, 0.125}), 1e-12);
  hand.follow(hand_at({0.0, 0.0, 0.1}));
  hand.advance(2051 * ms, false);
  EXPECT_EQ(hand.goal(), Vector<3>(0.0, 0.0, 0.1));
}

TEST(SimulatedHand, IsShakenAroundItsPlan) {
  SimulatedHand hand(hand_at({0.02, 0.0, 0.125}), 0);
  const Vector<3> way(0.0, 0.001, 0.0);
  hand.shake(way, 300.0);
  hand.advance(100 * ms, false);
  EXPECT_EQ(hand.goal(), Vector<3>(0.02, 0.001, 0.125));
  EXPECT_EQ(hand.stiffness(), 300.0);
  hand.shake(Vector<3>(0.0), {});
  EXPECT_EQ(hand.goal(), Vector<3>(0.02, 0.0, 0.125));
  EXPECT_EQ(hand.stiffness(), 100.0);
}

TEST(SimulatedHand, PaysAttentionWhileItHomes) {
  HandPlan plan = hand_at(HandPlan::centre);
  plan.homes_when_asked = true;
  SimulatedHand shaken(plan, 0);
  SimulatedHand still(plan, 0);
  shaken.shake(Vector<3>(0.001), 700.0);
  for (std::int64_t now = 0; now < 2000 * ms; now += 10 * ms) {
    shaken.advance(now, true);
    still.advance(now, true);
    ASSERT_TRUE(shaken.is_homing());
    ASSERT_EQ(shaken.goal(), still.goal());
    ASSERT_EQ(shaken.stiffness(), still.stiffness());
  }
}

TEST(SimulatedHand, HomesADeviceThatAsksForItAndGoesBackToItsPlan) {
  HandPlan plan = hand_at({0.0, 0.01, 0.12}, 0.2);
  plan.homes_when_asked = true;
  SimulatedHand hand(plan, 0);
  double farthest = 0.0;
  double nearest = 1.0;
  bool has_homed = false;
  for (int i = 0; i < 5000; ++i) {
    hand.advance(i * ms, i < 1600);
    if (hand.is_homing()) has_homed = true;
    farthest = std::max(farthest, hand.goal().z);
    nearest = std::min(nearest, hand.goal().z);
  }
  EXPECT_TRUE(has_homed);
  EXPECT_FALSE(hand.is_homing());
  EXPECT_GT(farthest, 0.174);
  EXPECT_LT(nearest, 0.074);
  EXPECT_EQ(hand.goal(), Vector<3>(0.0, 0.01, 0.12));
  // As long as it is asked, again and again.
  for (int i = 5000; i < 12000; ++i) hand.advance(i * ms, true);
  EXPECT_TRUE(hand.is_homing());
}

TEST(HandPlan, TakesNoMoreWaypointsThanItHasPlacesFor) {
  HandPlan plan;
  for (int i = 0; i < 100; ++i) plan.add({.time = i * 0.1});
  EXPECT_EQ(plan.count, plan.waypoints.size());
}

}  // namespace
}  // namespace ghostforce::hand_test
