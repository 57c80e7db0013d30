// HandEstimator on hands that nobody has told it about: tests/support/hand_at_wall.h. The bounds are those asked of it
// for recordings of hidden hands; hands are seeded, so that the numbers are the same every time.
#include <cmath>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "core/hand_estimator.h"
#include "tests/support/hand_at_wall.h"

namespace ghostforce::hand_population_test {
namespace {

constexpr std::uint64_t hands = 100;

struct Tally {
  int near = 0;  // within 20 % of the truth
  int known = 0;
  int right = 0;  // known, and near
};

Tally tally_of(HandPopulation population, double tone_force, double window_s, bool has_tone_column_without_tones) {
  Tally tally;
  for (std::uint64_t seed = 1; seed <= hands; ++seed) {
    const HandOfTest hand = draw_hand(population, seed);
    HandEstimator estimator(1000.0, window_s);
    std::int64_t tick = 0;
    for (HandSample sample : samples_of(hand, tone_force, window_s + 0.25)) {
      if (has_tone_column_without_tones) sample.tone = two_tones(0.4, static_cast<double>(++tick) / 1000.0);
      estimator.add(sample);
    }
    const HandEstimate estimate = estimator.estimate();
    const bool is_near = std::abs(estimate.k_u / hand.k_u - 1.0) < 0.2;
    tally.near += is_near ? 1 : 0;
    tally.known += estimate.is_known() ? 1 : 0;
    tally.right += estimate.is_known() && is_near ? 1 : 0;
  }
  return tally;
}

class HandPopulationTest : public testing::TestWithParam<HandPopulation> {};

TEST_P(HandPopulationTest, NineInTenAreNearTheTruthAndWhatIsKnownIsRight) {
  const Tally tally = tally_of(GetParam(), 0.4, 2.0, false);
  EXPECT_GE(tally.near, 90);
  EXPECT_GE(tally.known, 80);
  EXPECT_GE(tally.right, 0.95 * tally.known);
}

TEST_P(HandPopulationTest, FourSecondsAreBetterThanTwo) {
  const Tally two = tally_of(GetParam(), 0.4, 2.0, false);
  const Tally four = tally_of(GetParam(), 0.4, 4.0, false);
  EXPECT_GE(four.near, two.near);
  EXPECT_GT(four.known, two.known);
  EXPECT_GT(four.right, two.right);
  EXPECT_GE(four.near, 95);
  EXPECT_GE(four.known, 95);
  EXPECT_GE(four.right, 0.97 * four.known);
}

// Half the tones: fewer are known, and what is known is still right.
TEST_P(HandPopulationTest, QuietTonesKnowLessAndClaimLess) {
  const Tally loud = tally_of(GetParam(), 0.4, 2.0, false);
  const Tally quiet = tally_of(GetParam(), 0.2, 2.0, false);
  EXPECT_LT(quiet.known, loud.known);
  EXPECT_GE(quiet.known, 60);
  EXPECT_GE(quiet.right, 0.9 * quiet.known);
}

TEST_P(HandPopulationTest, WithoutTonesNothingIsKnown) {
  const Tally silent = tally_of(GetParam(), 0.0, 2.0, false);
  EXPECT_EQ(silent.known, 0);
  EXPECT_EQ(silent.near, 0);  // there is not even a number
  // Also where a column says that there were tones.
  EXPECT_LE(tally_of(GetParam(), 0.0, 2.0, true).known, 2);
}

INSTANTIATE_TEST_SUITE_P(Both, HandPopulationTest, testing::Values(HandPopulation::tied, HandPopulation::apart),
                         [](const testing::TestParamInfo<HandPopulation>& each) {
                           return std::string(each.param == HandPopulation::tied ? "tied" : "apart");
                         });

}  // namespace
}  // namespace ghostforce::hand_population_test
