#include "core/impedance.h"

#include <type_traits>

#include <gtest/gtest.h>

#include "tests/core/random_setting.h"

namespace ghostforce {
namespace {

TEST(ImpedanceTest, OptimalRatioIsOnePlusStiffnessRatio) {
  EXPECT_EQ(optimal_tracking_ratio(1000.0, 100.0), 11.0);
  EXPECT_EQ(optimal_tracking_ratio(0.0, 100.0), 1.0);  // nothing rendered: nothing to cure
  EXPECT_EQ(optimal_tracking_ratio(100.0, 400.0), 1.25);
}

TEST(ImpedanceTest, RatioFollowsTheBeliefUnlessChosen) {
  Impedances impedances = stiffnesses(100.0, 1000.0, 500.0, 1e5);
  EXPECT_EQ(believed_user_stiffness(impedances), 100.0);
  EXPECT_EQ(tracking_ratio(impedances), 11.0);

  impedances.believed_k_u = 50.0;
  EXPECT_EQ(believed_user_stiffness(impedances), 50.0);
  EXPECT_EQ(tracking_ratio(impedances), 21.0);

  impedances.chosen_tracking_ratio = 3.0;
  EXPECT_EQ(tracking_ratio(impedances), 3.0);
}

static_assert(std::is_trivially_copyable_v<Impedances>);
static_assert(noexcept(tracking_ratio(Impedances{})));

}  // namespace
}  // namespace ghostforce
