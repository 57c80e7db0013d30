#include "core/belief.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/stiffness.h"
#include "tests/core/random_setting.h"

namespace ghostforce::belief_follower_test {
namespace {

constexpr double k_r = 600.0;       // [N/m]
constexpr double fallback = 150.0;  // [N/m]
// ln ρ is worked out from the belief and back: some roundings, more where ρ is so near to 1 that k_r/k_u is lost in it.
constexpr double rounding = 1e-9;

HandEstimate known(double k_u) {
  return {.why = HandUnknown::none, .k_u = k_u, .sigma = 0.05 * k_u, .mass = 0.2, .damping = 5.0};
}
HandEstimate unknown(HandUnknown why = HandUnknown::no_contact) {
  return {.why = why};
}

double log_ratio(double k_u, double rendering = k_r) {
  return std::log(optimal_tracking_ratio(rendering, k_u));
}

int updates_to(BeliefFollower& follower, const HandEstimate& estimate, double aim, int most = 1000) {
  for (int count = 1; count <= most; ++count) {
    if (follower.update(estimate, k_r, fallback) == aim) return count;
  }
  return most + 1;
}

TEST(BeliefFollowerTest, StaysWhereTheHandIsTheSame) {
  for (const double hand : {200.0, 200.0 * std::exp(0.099), 200.0 * std::exp(-0.099)}) {
    BeliefFollower follower(200.0);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(follower.update(known(hand), k_r, fallback), 200.0);
  }
  for (const double hand : {200.0 * std::exp(0.101), 200.0 * std::exp(-0.101)}) {
    BeliefFollower follower(200.0);
    EXPECT_LT(updates_to(follower, known(hand), hand), 5);
  }
}

// It is measured from where it goes to, so that a hand that creeps in small steps is followed too.
TEST(BeliefFollowerTest, AHandThatCreepsIsFollowed) {
  BeliefFollower follower(200.0);
  double believed = 200.0;
  for (double hand = 200.0; hand < 800.0; hand *= 1.005) believed = follower.update(known(hand), k_r, fallback);
  EXPECT_NEAR(std::log(800.0 / believed), 0.05, 0.06);  // within the hysteresis
}

TEST(BeliefFollowerTest, RaisesTheRatioThreeTimesAsFastAsItLowersIt) {
  BeliefFollower softer(1000.0);
  double before = 1000.0;
  for (int i = 0; i < 3; ++i) {
    const double now = softer.update(known(50.0), k_r, fallback);
    EXPECT_NEAR(log_ratio(now) - log_ratio(before), 0.3, rounding);
    before = now;
  }
  BeliefFollower stiffer(50.0);
  before = 50.0;
  for (int i = 0; i < 15; ++i) {
    const double now = stiffer.update(known(1000.0), k_r, fallback);
    EXPECT_NEAR(log_ratio(now) - log_ratio(before), -0.1, rounding);
    before = now;
  }
}

TEST(BeliefFollowerTest, NeverFasterThanItMayWhateverComes) {
  Random random(31);
  for (const double rendering : {20.0, 600.0, 5000.0}) {
    BeliefFollower follower(300.0);
    double before = 300.0;
    double hand = 300.0;
    bool is_known = true;
    for (int i = 0; i < 20000; ++i) {
      if (random.once_in(7)) hand = random.over_decades(20.0, 2000.0);
      if (random.once_in(20)) is_known = !is_known;
      const double now = follower.update(is_known ? known(hand) : unknown(), rendering, fallback);
      ASSERT_TRUE(now > 0.0 && std::isfinite(now));
      ASSERT_GE(now, 19.0);
      ASSERT_LE(now, 2001.0);
      const double step = log_ratio(now, rendering) - log_ratio(before, rendering);
      ASSERT_LE(step, 0.3 + rounding);
      ASSERT_GE(step, -0.1 - rounding);
      before = now;
    }
  }
}

TEST(BeliefFollowerTest, EndsExactlyThereAndThenNothingChangesAnyMore) {
  Random random(32);
  for (int i = 0; i < 200; ++i) {
    const double from = random.over_decades(20.0, 2000.0);
    const double to = random.over_decades(20.0, 2000.0);
    if (std::abs(std::log(to / from)) < 0.11) continue;
    BeliefFollower follower(from);
    const int count = updates_to(follower, known(to), to);
    const double way = log_ratio(to) - log_ratio(from);
    EXPECT_EQ(count, std::ceil(way > 0.0 ? way / 0.3 : -way / 0.1)) << from << " to " << to;
    for (int more = 0; more < 50; ++more) ASSERT_EQ(follower.update(known(to), k_r, fallback), to);
    // And it does not run after what trembles around it.
    for (int more = 0; more < 50; ++more) {
      ASSERT_EQ(follower.update(known(to * random.uniform(0.92, 1.09)), k_r, fallback), to);
    }
  }
}

TEST(BeliefFollowerTest, HoldsForThreeSecondsAndThenGlides) {
  BeliefFollower follower(500.0);
  for (int i = 0; i < 30; ++i) ASSERT_EQ(follower.update(unknown(), k_r, fallback), 500.0) << i;
  double before = 500.0;
  int count = 0;
  while (before != fallback && count < 100) {
    const double now = follower.update(unknown(), k_r, fallback);
    ASSERT_LT(now, before);
    ASSERT_LE(log_ratio(now) - log_ratio(before), 0.3 + rounding);
    before = now;
    ++count;
  }
  EXPECT_EQ(count, std::ceil((log_ratio(fallback) - log_ratio(500.0)) / 0.3));
  for (int i = 0; i < 50; ++i) EXPECT_EQ(follower.update(unknown(), k_r, fallback), fallback);
}

TEST(BeliefFollowerTest, AGlanceOfTheHandBeginsTheThreeSecondsAnew) {
  BeliefFollower follower(500.0);
  for (int round = 0; round < 10; ++round) {
    for (int i = 0; i < 30; ++i) ASSERT_EQ(follower.update(unknown(), k_r, fallback), 500.0);
    ASSERT_EQ(follower.update(known(500.0), k_r, fallback), 500.0);
  }
}

// Known again while it glides: back to the hand, also where that is near to what was believed before.
TEST(BeliefFollowerTest, ComesBackToTheHandFromTheGlide) {
  BeliefFollower follower(500.0);
  for (int i = 0; i < 32; ++i) follower.update(unknown(), k_r, fallback);
  EXPECT_LT(updates_to(follower, known(510.0), 510.0), 20);
}

TEST(BeliefFollowerTest, NumbersThatAreNotReliedOnAreNotFollowed) {
  for (const HandUnknown why : {HandUnknown::too_much_tremor, HandUnknown::out_of_range}) {
    BeliefFollower follower(500.0);
    HandEstimate estimate = known(60.0);
    estimate.why = why;
    for (int i = 0; i < 30; ++i) ASSERT_EQ(follower.update(estimate, k_r, fallback), 500.0);
  }
}

TEST(BeliefFollowerTest, WithoutARenderedForceEveryBeliefIsAsGood) {
  BeliefFollower follower(500.0);
  EXPECT_EQ(follower.update(known(60.0), 0.0, fallback), 60.0);
  for (int i = 0; i < 40; ++i) {
    const double now = follower.update(unknown(), 0.0, fallback);
    ASSERT_TRUE(now == 60.0 || now == fallback) << now;
  }
  // And a k_r that comes afterwards is taken from there.
  EXPECT_EQ(follower.update(unknown(), k_r, fallback), fallback);
}

TEST(BeliefFollowerTest, AStepOfTheRenderingStiffnessDoesNotMoveTheBelief) {
  BeliefFollower follower(300.0);
  for (const double rendering : {600.0, 5000.0, 1e-6, 1e6, 600.0}) {
    EXPECT_EQ(follower.update(known(300.0), rendering, fallback), 300.0);
  }
}

TEST(BeliefFollowerTest, TheSmallestRenderingStiffnessIsNoDivisionByZero) {
  for (const double rendering : {5e-324, 1e-300, 1e-14, 1e-9, 1e6}) {
    BeliefFollower follower(1000.0);
    for (int i = 0; i < 500; ++i) {
      const double now = follower.update(i % 100 < 50 ? known(50.0) : known(1000.0), rendering, fallback);
      ASSERT_TRUE(now >= 49.9 && now <= 1000.1) << rendering << ": " << now;
    }
  }
}

}  // namespace
}  // namespace ghostforce::belief_follower_test
