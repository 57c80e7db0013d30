#include "core/ghost_force.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/core/dimensions.h"
#include "tests/core/random_setting.h"

namespace ghostforce::ghost_force_test {
namespace {

// Unit vectors and projectors: a few products of numbers no larger than 1.
constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

template <typename Dimension>
class GhostForceTest : public testing::Test {};
TYPED_TEST_SUITE(GhostForceTest, Dimensions, DimensionName);

TYPED_TEST(GhostForceTest, IsTheExcessAlongTheMotors) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Actuation<D> actuation =
        actuated_along<D>(std::span<const Vector<D>>(random_basis<D>(random, 1 + random.below(D - 1))));
    const Vector<D> full = random.direction<D>();
    const Vector<D> excess = actuation.actuated * random.direction<D>();
    // What the motors should do and no more: nothing across them, though `full` has that too.
    EXPECT_LE(glm::length(ghost_force(actuation, actuation.actuated * full, full)), rounding);
    EXPECT_LE(glm::length(ghost_force(actuation, actuation.actuated * full + excess, full) - excess), rounding);
    EXPECT_EQ(ghost_force(actuation, full, full), Vector<D>(0.0));
  }
}

TYPED_TEST(GhostForceTest, DriftIsAlongTheWall) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Wall<D> wall{random.in_box<D>(0.1), random.direction<D>()};
    const Vector<D> goal = random.in_box<D>(0.1);
    const Vector<D> slid = along(wall, random.in_box<D>(0.1));
    const double out = random.uniform(-0.1, 0.1);
    EXPECT_LE(glm::length(proxy_drift(wall, goal + slid + out * wall.normal, goal) - slid), rounding);
  }
}

TEST(GhostForce, HasTheSignOfTheExcess) {
  const Actuation<2> actuation = actuated_along(Vector<2>{1.0, 0.0});
  EXPECT_EQ(ghost_force(actuation, Vector<2>(-6.0, 0.0), Vector<2>(-4.0, 4.0)), Vector<2>(-2.0, 0.0));
  const Wall<2> floor{{0.0, 0.0}, {0.0, 1.0}};
  EXPECT_EQ(proxy_drift(floor, Vector<2>(-3.0, 0.0), Vector<2>(1.0, -2.0)), Vector<2>(-4.0, 0.0));
}

static_assert(noexcept(ghost_force(Actuation<2>{}, Vector<2>{}, Vector<2>{})));
static_assert(noexcept(proxy_drift(Wall<2>{}, Vector<2>{}, Vector<2>{})));

}  // namespace
}  // namespace ghostforce::ghost_force_test
