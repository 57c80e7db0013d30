// The hand on the simulated arms: its plan, and how it brings the arms into the zero pose and comes back.
#include "device/virtual_haply/haply_hand.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "device/virtual_haply/virtual_haply_variant.h"
#include "tests/device/virtual_haply/hapi_bytes.h"

namespace ghostforce::haply_hand_test {
namespace {

using hapi_bytes::ms;

const VirtualHaplyVariant& variant() {
  return *find_virtual_haply_variant("v3.1");
}

struct Held {
  HaplyArms arms{variant().geometry, {}, *variant().geometry.angles_at(variant().geometry.middle())};
  VirtualHaplyHand hand{{}, variant().geometry.middle(), 0};
  std::int64_t now_ns = 0;

  void live(std::int64_t ns) {
    for (const std::int64_t end_ns = now_ns + ns; now_ns < end_ns; now_ns += 50'000) {
      hand.advance(now_ns, arms, variant().zero_pose());
      arms.step(50e-6, Vector<2>{0.0}, hand.pull());
    }
  }
};

TEST(HaplyHand, FollowsItsPlanInStraightLines) {
  Held held;
  held.live(10 * ms);
  EXPECT_EQ(held.hand.pull().goal, variant().geometry.middle());
  HaplyHandPlan plan = haply_hand_at({0.04, 0.09}, 0.1);
  plan.add({.time = 0.2, .goal = {0.04, 0.11}});
  plan.stiffness = 250.0;
  held.hand.follow(plan);
  const std::int64_t start_ns = held.now_ns;
  held.live(50 * ms + 50'000);
  EXPECT_NEAR(held.hand.pull().goal.x, 0.5 * (0.019 + 0.04), 1e-4);
  EXPECT_EQ(held.hand.pull().stiffness, 250.0);
  held.live(start_ns + 150 * ms - held.now_ns + 50'000);
  EXPECT_NEAR(held.hand.pull().goal.y, 0.10, 1e-4);
  held.live(1000 * ms);
  EXPECT_EQ(held.hand.pull().goal, (Vector<2>{0.04, 0.11}));
  EXPECT_LT(glm::length(held.arms.handle() - held.hand.pull().goal), 1e-3);
}

TEST(HaplyHand, GoesNoFasterThanItIsAllowedTo) {
  Held held;
  HaplyHandPlan plan = haply_hand_at(variant().geometry.middle() + Vector<2>(0.03, 0.0));
  plan.greatest_speed = 0.5;
  held.hand.follow(plan);
  held.live(30 * ms + 50'000);
  EXPECT_NEAR(held.hand.pull().goal.x - variant().geometry.middle().x, 0.015, 1e-4);
  // A new plan begins where the hand is by then.
  plan.waypoints[0].goal = variant().geometry.middle();
  held.hand.follow(plan);
  held.live(15 * ms + 50'000);
  EXPECT_NEAR(held.hand.pull().goal.x - variant().geometry.middle().x, 0.0075, 1e-4);
}

TEST(HaplyHand, HoldsTheZeroPoseAndComesBack) {
  Held held;
  held.hand.hold_zero_pose(true);
  held.live(1 * ms);
  EXPECT_FALSE(held.hand.is_in_zero_pose());
  held.live(1500 * ms);
  EXPECT_TRUE(held.hand.is_in_zero_pose());
  const Vector<2> there = held.arms.handle();
  held.hand.hold_zero_pose(false);
  held.live(2 * ms);
  EXPECT_FALSE(held.hand.is_in_zero_pose());
  EXPECT_LT(glm::length(held.hand.pull().goal - there), 1e-3) << "without a jerk";
  held.live(1500 * ms);
  EXPECT_EQ(held.hand.pull().goal, variant().geometry.middle());
  EXPECT_LT(glm::length(held.arms.handle() - variant().geometry.middle()), 1e-3);
}

TEST(HaplyHand, LetsGo) {
  Held held;
  HaplyHandPlan plan;
  plan.stiffness = 0.0;
  held.hand.follow(plan);
  held.live(1 * ms);
  const Vector<2> before = held.arms.handle();
  for (int step = 0; step < 2000; ++step) held.arms.step(50e-6, {0.02, 0.0}, held.hand.pull());
  EXPECT_GT(glm::length(held.arms.handle() - before), 0.01) << "nothing holds it";
}

TEST(HaplyHandPlan, LeavesOutWhatIsTooMuch) {
  HaplyHandPlan plan;
  for (int i = 0; i < 40; ++i) plan.add({});
  EXPECT_EQ(plan.count, plan.waypoints.size());
}

}  // namespace
}  // namespace ghostforce::haply_hand_test
