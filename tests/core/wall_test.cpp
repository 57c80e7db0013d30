#include "core/wall.h"

#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/core/dimensions.h"
#include "tests/core/random_setting.h"

namespace ghostforce::wall_test {
namespace {

// Points lie within 0.2 m; a sum of D products of such numbers is good to a few roundings of that.
constexpr double rounding = 8.0 * 0.2 * std::numeric_limits<double>::epsilon();

template <typename Dimension>
class WallTest : public testing::Test {};
TYPED_TEST_SUITE(WallTest, Dimensions, DimensionName);

TYPED_TEST(WallTest, DistanceIsPositiveOnTheFreeSideAndDepthInside) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Wall<D> wall{random.in_box<D>(0.1), random.direction<D>()};
    const Vector<D> on_wall = wall.point + along(wall, random.in_box<D>(0.1));
    const double height = random.uniform(-0.05, 0.05);
    const Vector<D> q = on_wall + height * wall.normal;
    EXPECT_NEAR(signed_distance(wall, q), height, rounding);
    EXPECT_NEAR(depth(wall, q), -height, rounding);
  }
}

TYPED_TEST(WallTest, ProjectionIsTheNearestPointOfTheWall) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Wall<D> wall{random.in_box<D>(0.1), random.direction<D>()};
    const Vector<D> q = random.in_box<D>(0.1);
    const Vector<D> nearest = projection(wall, q);
    EXPECT_NEAR(signed_distance(wall, nearest), 0.0, rounding);
    EXPECT_LE(glm::length(projection(wall, nearest) - nearest), rounding);
    const Vector<D> elsewhere = wall.point + along(wall, random.in_box<D>(0.1));
    EXPECT_LE(glm::length(nearest - q), glm::length(elsewhere - q) + rounding);
  }
}

TYPED_TEST(WallTest, AlongHasNoPartAcrossTheWallAndLosesNothingOfWhatLiesInIt) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    SCOPED_TRACE(i);
    const Wall<D> wall{random.in_box<D>(0.1), random.direction<D>()};
    const Vector<D> v = random.in_box<D>(0.1);
    const Vector<D> slid = along(wall, v);
    EXPECT_NEAR(glm::dot(slid, wall.normal), 0.0, rounding);
    EXPECT_LE(glm::length(slid + wall.normal * glm::dot(wall.normal, v) - v), rounding);
    EXPECT_LE(glm::length(along(wall, slid) - slid), rounding);
  }
}

TEST(DirectionAt, TurnsCounterClockwiseFromX) {
  constexpr double quarter_turn = std::numbers::pi / 2.0;
  EXPECT_EQ(direction_at(0.0), Vector<2>(1.0, 0.0));
  EXPECT_LE(glm::length(direction_at(quarter_turn) - Vector<2>(0.0, 1.0)), rounding);
  EXPECT_LE(glm::length(direction_at(-quarter_turn) - Vector<2>(0.0, -1.0)), rounding);
  EXPECT_LE(glm::length(direction_at(1.5 * quarter_turn) - Vector<2>(-1.0, 1.0) / std::numbers::sqrt2), rounding);
}

static_assert(noexcept(projection(Wall<2>{}, Vector<2>{})) && noexcept(depth(Wall<2>{}, Vector<2>{})) && noexcept(
    along(Wall<2>{}, Vector<2>{})));

}  // namespace
}  // namespace ghostforce::wall_test
