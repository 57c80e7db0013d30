// What is kept of the hand, and how much of it.
#include "app/picture/plot_history.h"

#include <gtest/gtest.h>

namespace ghostforce::hand_history_test {
namespace {

constexpr double tick_s = 0.001;

HandPoint known(double time_s, double k_u, double believed = 200.0) {
  return {.time_s = time_s,
          .estimate = {.why = HandUnknown::none, .k_u = k_u, .sigma = 0.05 * k_u, .mass = 0.1, .damping = 5.0},
          .believed_k_u = believed,
          .given_k_u = {}};
}

TEST(HandHistory, HasNothingAtFirst) {
  const HandHistory history;
  EXPECT_TRUE(history.is_empty());
  EXPECT_EQ(history.at(1.0), nullptr);
  EXPECT_TRUE(history.between(0.0, 10.0).empty());
}

TEST(HandHistory, KeepsEveryEstimateAndHardlyMore) {
  HandHistory history;
  for (int k = 0; k < 10'000; ++k) history.add(known(tick_s * k, 100.0 + k / 100));
  // A new one every 0.1 s, each of them there from its very tick on.
  ASSERT_EQ(history.between(0.0, 10.0).size(), 100U);
  for (int k = 0; k < 10'000; k += 7) EXPECT_EQ(history.at(tick_s * k)->estimate.k_u, 100.0 + k / 100) << k;
}

TEST(HandHistory, KeepsEveryChangeOfTheBelief) {
  HandHistory history;
  for (int k = 0; k < 50; ++k) history.add(known(tick_s * k, 100.0, k < 17 ? 200.0 : 300.0));
  EXPECT_EQ(history.at(0.016)->believed_k_u, 200.0);
  EXPECT_EQ(history.at(0.017)->believed_k_u, 300.0);
  EXPECT_EQ(history.between(0.0, 1.0).size(), 2U);
}

TEST(HandHistory, APointEveryTenthOfASecondWhereNothingChanges) {
  HandHistory history;
  for (int k = 0; k <= 2000; ++k) history.add({.time_s = tick_s * k, .believed_k_u = 200.0});
  const auto points = history.between(0.0, 2.0);
  // 20, or 21 where sums of a thousandth reach a tenth a little late.
  EXPECT_GE(points.size(), 20U);
  EXPECT_LE(points.size(), 21U);
  EXPECT_GT(points.back().time_s, 1.8) << "a line through them goes on to the newest";
}

TEST(HandHistory, OnePointMoreOnEitherSideOfATime) {
  HandHistory history;
  for (int k = 0; k < 10; ++k) history.add(known(k, 100.0 + k));
  const auto points = history.between(3.5, 6.5);
  ASSERT_EQ(points.size(), 5U);
  EXPECT_EQ(points.front().time_s, 3.0);
  EXPECT_EQ(points.back().time_s, 7.0);
  EXPECT_EQ(history.between(-5.0, -4.0).size(), 1U) << "the first is the one after";
}

TEST(HandHistory, ATickThatIsNoLaterCountsOnce) {
  HandHistory history;
  history.add(known(1.0, 100.0));
  history.add(known(1.0, 300.0));
  history.add(known(0.5, 300.0));
  ASSERT_EQ(history.between(0.0, 2.0).size(), 1U);
  EXPECT_EQ(history.at(2.0)->estimate.k_u, 100.0);
  history.clear();
  EXPECT_TRUE(history.is_empty());
}

TEST(HandHistory, IsBoundedInTimeAndInNumber) {
  HandHistory history;
  for (int k = 0; k < 5000; ++k) history.add(known(0.1 * k, 100.0 + k));
  EXPECT_GE(history.between(0.0, 1e6).front().time_s, 499.9 - HandHistory::span_s - 1e-9);
  // A value that is another one at every tick, as a hand's that changes in time.
  history.clear();
  for (int k = 0; k < 20'000; ++k) history.add(known(tick_s * k, 100.0, 100.0 + k));
  EXPECT_EQ(history.between(0.0, 1e6).size(), HandHistory::most_points);
  EXPECT_EQ(history.at(1e6)->believed_k_u, 100.0 + 19'999);
}

}  // namespace
}  // namespace ghostforce::hand_history_test
