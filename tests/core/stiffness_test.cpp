#include "core/stiffness.h"

#include <type_traits>

#include <gtest/gtest.h>

#include "tests/core/random_setting.h"

namespace ghostforce::stiffness_test {
namespace {

TEST(StiffnessTest, OptimalRatioIsOnePlusStiffnessRatio) {
  EXPECT_EQ(optimal_tracking_ratio(1000.0, 100.0), 11.0);
  EXPECT_EQ(optimal_tracking_ratio(0.0, 100.0), 1.0);  // nothing rendered: nothing to cure
  EXPECT_EQ(optimal_tracking_ratio(100.0, 400.0), 1.25);
}

TEST(StiffnessTest, RatioFollowsTheBeliefUnlessChosen) {
  Stiffnesses stiffnesses = make_stiffnesses(100.0, 1000.0, 500.0, 1e5);
  EXPECT_EQ(believed_user_stiffness(stiffnesses), 100.0);
  EXPECT_EQ(tracking_ratio(stiffnesses), 11.0);

  stiffnesses.believed_k_u = 50.0;
  EXPECT_EQ(believed_user_stiffness(stiffnesses), 50.0);
  EXPECT_EQ(tracking_ratio(stiffnesses), 21.0);

  stiffnesses.chosen_tracking_ratio = 3.0;
  EXPECT_EQ(tracking_ratio(stiffnesses), 3.0);
}

static_assert(std::is_trivially_copyable_v<Stiffnesses>);
static_assert(noexcept(tracking_ratio(Stiffnesses{})));

}  // namespace
}  // namespace ghostforce::stiffness_test
