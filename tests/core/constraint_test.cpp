#include "core/constraint.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "tests/core/random_setting.h"

namespace ghostforce::constraint_test {
namespace {

static_assert(std::is_trivially_copyable_v<Constraint>);
static_assert(noexcept(linearised(std::declval<const Constraint&>(), std::declval<const Vector<2>&>())));

const Constraint corner = CornerWall{Vector<2>(0.01, 0.02), {direction_at(2.3), direction_at(0.7)}};
const Constraint ring = RoundWall{Vector<2>(0.01, -0.02), 0.035, true};
const Constraint disc = RoundWall{Vector<2>(0.01, -0.02), 0.035, false};
const Constraint wall = Wall<2>{Vector<2>(0.01, 0.02), direction_at(1.0)};

// Each outline is where the distance is zero, and the projection finds no point of it that a search does not.
TEST(Constraint, DistanceProjectionAndOutlineAgree) {
  for (const Constraint& constraint : {wall, corner, ring, disc}) {
    const Outline edge = outline(constraint, 0.3);
    ASSERT_GE(edge.count, 2U);
    for (std::size_t i = 0; i < edge.count; ++i) {
      EXPECT_NEAR(signed_distance(constraint, edge.points[i]), 0.0, 1e-15);
    }
    EXPECT_EQ(edge.is_closed, is_curved(constraint));
    Random random(7);
    for (int i = 0; i < 200; ++i) {
      const Vector<2> q = random.in_box<2>(0.1);
      const Vector<2> foot = projection(constraint, q);
      EXPECT_NEAR(signed_distance(constraint, foot), 0.0, 1e-15);
      double nearest = glm::length(q - edge.points[0]);
      const std::size_t pieces = edge.is_closed ? edge.count : edge.count - 1;
      for (std::size_t k = 0; k < pieces; ++k) {
        const Vector<2>& from = edge.points[k];
        const Vector<2>& to = edge.points[(k + 1) % edge.count];
        const double share = glm::dot(q - from, to - from) / glm::dot(to - from, to - from);
        nearest = std::min(nearest, glm::length(q - glm::mix(from, to, std::clamp(share, 0.0, 1.0))));
      }
      EXPECT_NEAR(glm::length(q - foot), nearest, 2e-5) << "the outline of a circle is a polygon";
    }
  }
}

TEST(Constraint, FreeIsInFrontOfBothWallsOfACorner) {
  const Vector<2> apex(0.01, 0.02);
  EXPECT_GT(signed_distance(corner, apex + 0.1 * direction_at(1.5)), 0.0);
  EXPECT_LT(signed_distance(corner, apex - 0.1 * direction_at(1.5)), 0.0);
  EXPECT_LT(signed_distance(corner, apex + 0.1 * direction_at(2.3 + 1.7)), 0.0) << "behind one wall alone";
  EXPECT_EQ(linearised(corner, apex).count, 2U);
}

TEST(Constraint, ARoundWallIsTheTangentPlaneNextToTheProxy) {
  for (const Constraint& constraint : {ring, disc}) {
    const double inwards = std::get<RoundWall>(constraint).is_free_inside ? -1.0 : 1.0;
    for (const double angle : {0.0, 1.0, 4.0}) {
      const Vector<2> out = direction_at(angle);
      const Planes<2> planes = linearised(constraint, Vector<2>(0.01, -0.02) + 0.02 * out);
      ASSERT_EQ(planes.count, 1U);
      EXPECT_LT(glm::length(planes.walls[0].normal - inwards * out), 1e-14);
      EXPECT_LT(glm::length(planes.walls[0].point - (Vector<2>(0.01, -0.02) + 0.035 * out)), 1e-15);
    }
    const Planes<2> planes = linearised(constraint, Vector<2>(0.01, -0.02));
    EXPECT_NEAR(glm::length(planes.walls[0].normal), 1.0, 1e-15) << "also from the centre";
  }
}

}  // namespace
}  // namespace ghostforce::constraint_test
