// The pantograph's kinematics: against the worked example and the published zero poses, against differences, against
// themselves, and where no place or no force is.
#include "device/haply/haply_kinematics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "device/haply/haply_calibration.h"
#include "device/virtual_haply/arms_geometry.h"

namespace ghostforce::haply_kinematics_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr PantographGeometry v3{.driven_length = 0.07, .distal_length = 0.09, .base = 0.038};

using Angles = std::array<double, 2>;

Angles radians(double first_deg, double second_deg) {
  return {first_deg * radians_per_degree, second_deg * radians_per_degree};
}

bool is_finite(const Vector<2>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}

bool is_finite(const PantographPose& pose) {
  return is_finite(pose.handle) && is_finite(pose.elbows[0]) && is_finite(pose.elbows[1]) &&
         is_finite(pose.directions[0]) && is_finite(pose.directions[1]) && is_finite(pose.jacobian[0]) &&
         is_finite(pose.jacobian[1]);
}

double cross(const Vector<2>& a, const Vector<2>& b) {
  return a.x * b.y - a.y * b.x;
}

// Of two matrices, relative to the size of the first.
double difference(const Matrix<2>& a, const Matrix<2>& b) {
  return (glm::length(a[0] - b[0]) + glm::length(a[1] - b[1])) / (glm::length(a[0]) + glm::length(a[1]));
}

// A sine between any two links that meet: near 0 no place and no force can be told.
double own_margin_of(const PantographPose& pose, const Angles& angles) {
  double margin = std::abs(cross(pose.directions[0], pose.directions[1]));
  for (std::size_t arm = 0; arm < 2; ++arm) {
    margin = std::min(margin, std::abs(cross({std::cos(angles[arm]), std::sin(angles[arm])}, pose.directions[arm])));
  }
  return margin;
}

struct RandomPoses {
  std::mt19937_64 random{7};

  Angles angles() {
    std::uniform_real_distribution<double> any(-std::acos(-1.0), std::acos(-1.0));
    const double first = any(random);
    return {first, any(random)};
  }
  const PantographGeometry& geometry() {
    const auto variants = haply_variant_catalog();
    return variants[random() % variants.size()].calibration.geometry;
  }
};

TEST(HaplyKinematics, AgreesWithTheWorkedExample) {
  const auto pose = pose_at(v3, radians(150.0, 50.0));
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->elbows[0].x, -0.06062, 1e-5);
  EXPECT_NEAR(pose->elbows[0].y, 0.03500, 1e-5);
  EXPECT_NEAR(pose->elbows[1].x, 0.08300, 1e-5);
  EXPECT_NEAR(pose->elbows[1].y, 0.05362, 1e-5);
  EXPECT_NEAR(pose->handle.x, 0.00431, 1e-5);
  EXPECT_NEAR(pose->handle.y, 0.09732, 1e-5);
  const auto degrees = [](const Vector<2>& v) { return std::atan2(v.y, v.x) * degrees_per_radian; };
  EXPECT_NEAR(degrees(pose->directions[0]), 43.821, 1e-3);
  EXPECT_NEAR(degrees(pose->directions[1]), 150.955, 1e-3);
  EXPECT_NEAR(pose->jacobian[0].x, -0.03415, 1e-5);
  EXPECT_NEAR(pose->jacobian[1].x, -0.04980, 1e-5);
  EXPECT_NEAR(pose->jacobian[0].y, -0.06150, 1e-5);
  EXPECT_NEAR(pose->jacobian[1].y, 0.05189, 1e-5);
  const auto along_x = torques_for(*pose, {1.0, 0.0});
  EXPECT_NEAR(along_x[0], -0.03415, 1e-5);
  EXPECT_NEAR(along_x[1], -0.04980, 1e-5);
  const auto along_y = torques_for(*pose, {0.0, 1.0});
  EXPECT_NEAR(along_y[0], -0.06150, 1e-5);
  EXPECT_NEAR(along_y[1], 0.05189, 1e-5);
  const auto first = force_of(*pose, {1.0, 0.0});
  const auto second = force_of(*pose, {0.0, 1.0});
  ASSERT_TRUE(first && second);
  EXPECT_NEAR(first->x, -10.732, 1e-3);
  EXPECT_NEAR(first->y, -10.300, 1e-3);
  EXPECT_NEAR(second->x, -12.721, 1e-3);
  EXPECT_NEAR(second->y, 7.064, 1e-3);
  const auto full = force_of(*pose, {0.123, 0.0});
  EXPECT_NEAR(full->x, -1.320, 1e-3);
  EXPECT_NEAR(full->y, -1.267, 1e-3);
  EXPECT_NEAR(glm::length(*full), 1.830, 1e-3);
  EXPECT_NEAR(line_of_motor(*pose, 0).x, 0.7215, 1e-4);
  EXPECT_NEAR(line_of_motor(*pose, 0).y, 0.6924, 1e-4);
}

TEST(HaplyKinematics, AgreesWithThePublishedZeroPoses) {
  struct Row {
    std::string_view variant;
    Vector<2> handle;
  };
  for (const Row& row :
       {Row{"2017", {0.0100, 0.0361}}, Row{"v2", {0.0, 0.0221}}, Row{"v3", {0.0190, 0.1550}},
        Row{"v3.1", {0.0190, 0.0357}}, Row{"v2", {-0.0000129, 0.0220957}}, Row{"v3.1", {0.01902, 0.03574}}}) {
    SCOPED_TRACE(row.variant);
    const HaplyCalibration& calibration = find_haply_variant(row.variant)->calibration;
    const auto pose =
        pose_at(calibration.geometry, radians(calibration.arms[0].offset_deg, calibration.arms[1].offset_deg));
    ASSERT_TRUE(pose);
    EXPECT_LT(glm::length(pose->handle - row.handle), 1e-4);
  }
}

// Two programs, neither of whose authors has seen the other's.
TEST(HaplyKinematics, AgreesWithTheSimulatedArms) {
  RandomPoses poses;
  int compared = 0;
  for (int i = 0; i < 10'000; ++i) {
    const PantographGeometry& geometry = poses.geometry();
    const Angles angles = poses.angles();
    const ArmsGeometry arms{geometry.driven_length, geometry.distal_length, geometry.base};
    const auto pose = pose_at(geometry, angles);
    const auto place = arms.place({angles[0], angles[1]});
    if (!pose || !place) continue;
    ++compared;
    ASSERT_LT(glm::length(pose->handle - place->handle), 1e-9);
    if (own_margin_of(*pose, angles) > 1e-3) {
      ASSERT_LT(difference(pose->jacobian, place->jacobian), 1e-6);
    }
  }
  EXPECT_GT(compared, 2'000);
}

TEST(HaplyKinematics, TheJacobianIsThatOfTheHandlesPlace) {
  RandomPoses poses;
  int compared = 0;
  constexpr double step = 1e-6;
  while (compared < 10'000) {
    const PantographGeometry& geometry = poses.geometry();
    const Angles angles = poses.angles();
    const auto pose = pose_at(geometry, angles);
    if (!pose || own_margin_of(*pose, angles) < 0.02 || glm::length(pose->elbows[1] - pose->elbows[0]) < 1e-3) continue;
    Matrix<2> differences{0.0};
    bool is_whole = true;
    for (std::size_t arm = 0; arm < 2; ++arm) {
      Angles more = angles;
      Angles less = angles;
      more[arm] += step;
      less[arm] -= step;
      const auto after = pose_at(geometry, more);
      const auto before = pose_at(geometry, less);
      is_whole &= after && before;
      if (after && before) {
        differences[static_cast<glm::length_t>(arm)] = (after->handle - before->handle) / (2.0 * step);
      }
    }
    if (!is_whole) continue;
    ++compared;
    ASSERT_LT(difference(pose->jacobian, differences), 1e-4) << angles[0] << ' ' << angles[1];
  }
}

TEST(HaplyKinematics, GoesThereAndBack) {
  std::mt19937_64 random{3};
  for (const HaplyVariant& variant : haply_variant_catalog()) {
    SCOPED_TRACE(variant.name);
    const PantographGeometry& geometry = variant.calibration.geometry;
    std::uniform_real_distribution<double> aside(-0.04, 0.04);
    int compared = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vector<2> place = variant.calibration.center + Vector<2>(aside(random), aside(random));
      const auto angles = angles_at(geometry, place);
      if (!angles) continue;
      const auto pose = pose_at(geometry, *angles);
      ASSERT_TRUE(pose) << place.x << ' ' << place.y;
      ASSERT_LT(glm::length(pose->handle - place), 1e-9) << place.x << ' ' << place.y;
      const auto again = angles_at(geometry, pose->handle);
      ASSERT_TRUE(again);
      ASSERT_NEAR((*again)[0], (*angles)[0], 1e-7);
      ASSERT_NEAR((*again)[1], (*angles)[1], 1e-7);
      ++compared;
    }
    EXPECT_GT(compared, 2000);
  }
}

TEST(HaplyKinematics, TorquesOfAForceMakeThatForce) {
  RandomPoses poses;
  int compared = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Angles angles = poses.angles();
    const auto pose = pose_at(poses.geometry(), angles);
    if (!pose || own_margin_of(*pose, angles) < 0.01) continue;
    ++compared;
    const Vector<2> force(3.0 * std::cos(i), 3.0 * std::sin(i));
    const auto back = force_of(*pose, torques_for(*pose, force));
    ASSERT_TRUE(back);
    ASSERT_LT(glm::length(*back - force), 1e-9);
    // Virtual work: a motor's torque times its turn is the force times the handle's way.
    const Angles torques = torques_for(*pose, force);
    for (std::size_t arm = 0; arm < 2; ++arm) {
      ASSERT_NEAR(torques[arm], glm::dot(pose->jacobian[static_cast<glm::length_t>(arm)], force), 1e-15);
    }
  }
  EXPECT_GT(compared, 2'000);
}

TEST(HaplyKinematics, OneMotorPushesAlongItsLine) {
  RandomPoses poses;
  int compared = 0;
  for (int i = 0; i < 10'000; ++i) {
    const PantographGeometry& geometry = poses.geometry();
    const Angles angles = poses.angles();
    const auto pose = pose_at(geometry, angles);
    if (!pose || own_margin_of(*pose, angles) < 0.05) continue;
    ++compared;
    for (std::size_t arm = 0; arm < 2; ++arm) {
      Angles torques{};
      torques[arm] = 0.05;
      const auto force = force_of(*pose, torques);
      ASSERT_TRUE(force);
      const Vector<2> line = line_of_motor(*pose, arm);
      ASSERT_NEAR(glm::length(line), 1.0, 1e-12);
      ASSERT_NEAR(cross(*force, line), 0.0, 1e-12 * glm::length(*force));
      // The closed form: f = a τ / (l sin(φ − θ)).
      const double sine = cross({std::cos(angles[arm]), std::sin(angles[arm])}, line);
      ASSERT_NEAR(glm::dot(*force, line), 0.05 / (geometry.driven_length * sine), 1e-9 * glm::length(*force));
      ASSERT_NEAR(lever_of_motor(*pose, arm), 0.05 / glm::length(*force), 1e-9 * geometry.driven_length);
      // And the other way round: a force along the line needs nothing of the other motor.
      ASSERT_NEAR(torques_for(*pose, line)[1 - arm], 0.0, 1e-12);
    }
  }
  EXPECT_GT(compared, 2'000);
}

TEST(HaplyKinematics, ThereIsNoPlaceWhereTheArmsDoNotMeet) {
  for (const double wrong : {nan, infinity, -infinity}) {
    EXPECT_FALSE(pose_at(v3, {wrong, 0.5}));
    EXPECT_FALSE(pose_at(v3, {0.5, wrong}));
    EXPECT_FALSE(angles_at(v3, {wrong, 0.1}));
    EXPECT_FALSE(angles_at(v3, {0.1, wrong}));
  }
  const PantographGeometry wide{.driven_length = 0.07, .distal_length = 0.03, .base = 0.038};
  EXPECT_FALSE(pose_at(wide, radians(180.0, 0.0))) << "elbows 178 mm apart, links of 60 mm";
  EXPECT_FALSE(pose_at(v3, radians(20.0, 160.0))) << "the arms have passed through each other";
  const PantographGeometry one_base{.driven_length = 0.07, .distal_length = 0.09, .base = 0.0};
  EXPECT_FALSE(pose_at(one_base, radians(90.0, 90.0))) << "the elbows meet";
  EXPECT_FALSE(angles_at(v3, {0.0, 0.3}));
  EXPECT_FALSE(angles_at(v3, {0.0, 0.0})) << "on the motor itself";
  EXPECT_FALSE(angles_at(v3, {0.019, 1e-3})) << "nearer than the links can fold";
}

// Up to the last angle at which the distal links are still apart, and beyond.
TEST(HaplyKinematics, IsEmptyOrFiniteWhereDistalLinksComeInLine) {
  const PantographGeometry narrow{.driven_length = 0.07, .distal_length = 0.06, .base = 0.038};
  int empty = 0;
  int found = 0;
  const double edge = std::acos((0.06 - 0.019) / 0.07);
  for (double aside = 1e-2; aside > 1e-17; aside *= 0.5) {
    for (const double sign : {-1.0, 1.0}) {
      const Angles angles{std::acos(-1.0) - edge - sign * aside, edge + sign * aside};
      const auto pose = pose_at(narrow, angles);
      (pose ? found : empty) += 1;
      if (!pose) continue;
      EXPECT_TRUE(is_finite(*pose)) << aside;
      if (const auto force = force_of(*pose, {0.05, -0.05})) {
        EXPECT_TRUE(is_finite(*force)) << aside;
      }
      EXPECT_FALSE(std::isnan(condition_of(*pose)));
    }
  }
  EXPECT_GT(empty, 10);
  EXPECT_GT(found, 10);
}

// An arm that is straight: its motor cannot push along its line any more, and does not move the handle either way.
TEST(HaplyKinematics, IsEmptyOrFiniteWhereAnArmIsStraight) {
  for (double aside = 1e-2; aside > 1e-17; aside *= 0.5) {
    const double reach = 0.16 - aside * aside;
    const auto angles = angles_at(v3, {0.0, reach});
    if (!angles) continue;
    const auto pose = pose_at(v3, *angles);
    if (!pose) continue;
    EXPECT_TRUE(is_finite(*pose));
    if (const auto force = force_of(*pose, {0.05, 0.0})) {
      EXPECT_TRUE(is_finite(*force)) << aside;
    }
    EXPECT_GT(condition_of(*pose), 1.0);
  }
}

TEST(HaplyKinematics, NothingIsEverHalfANumber) {
  RandomPoses poses;
  for (int i = 0; i < 100'000; ++i) {
    Angles angles = poses.angles();
    for (double& angle : angles) {
      if (poses.random() % 4 == 0) angle = std::round(angle / 0.7853981633974483) * 0.7853981633974483;
    }
    const auto pose = pose_at(poses.geometry(), angles);
    if (!pose) continue;
    ASSERT_TRUE(is_finite(*pose)) << angles[0] << ' ' << angles[1];
    const auto force = force_of(*pose, {0.1, -0.1});
    ASSERT_TRUE(!force || is_finite(*force));
  }
}

// How far a circle of angles is stretched into an ellipse of places, by going round it.
TEST(HaplyKinematics, TheConditionIsThatOfTheEllipse) {
  double least = infinity;
  for (double x = -0.011; x <= 0.0491; x += 0.006) {
    for (double y = 0.06; y <= 0.1201; y += 0.006) {
      const auto angles = angles_at(v3, {x, y});
      ASSERT_TRUE(angles);
      const auto pose = pose_at(v3, *angles);
      ASSERT_TRUE(pose);
      Vector<2> range(infinity, 0.0);
      for (double turn = 0.0; turn < 3.1416; turn += 1e-3) {
        const double way = glm::length(pose->jacobian * Vector<2>(std::cos(turn), std::sin(turn)));
        range = {std::min(range.x, way), std::max(range.y, way)};
      }
      EXPECT_NEAR(condition_of(*pose), range.y / range.x, 1e-4 * range.y / range.x);
      least = std::min(least, condition_of(*pose));
    }
  }
  EXPECT_NEAR(least, 1.01, 0.01);
}

// Where a simulated hand may lead: on the way from the middle, and never through a pose in which links are in line.
TEST(HaplyKinematics, TheNearestPlaceWithinReachIsOnTheWayAndWellWithinTheArms) {
  for (const HaplyVariant& variant : haply_variant_catalog()) {
    const PantographGeometry& geometry = variant.calibration.geometry;
    const Vector<2>& center = variant.calibration.center;
    EXPECT_EQ(nearest_within_reach(geometry, center, center), center) << variant.name;
    for (double angle = 0.0; angle < 6.28; angle += 0.1) {
      for (const double distance : {0.005, 0.03, 0.1, 1.0}) {
        const Vector<2> way(std::cos(angle), std::sin(angle));
        const Vector<2> found = nearest_within_reach(geometry, center, center + distance * way);
        const Vector<2> from_center = found - center;
        EXPECT_NEAR(from_center.x * way.y - from_center.y * way.x, 0.0, 1e-12);
        EXPECT_LE(glm::length(from_center), distance + 1e-12);
        const auto angles = angles_at(geometry, found);
        ASSERT_TRUE(angles) << variant.name << ' ' << angle;
        const auto pose = pose_at(geometry, *angles);
        ASSERT_TRUE(pose);
        EXPECT_GE(margin_of(*pose, *angles), 0.3 - 1e-9) << variant.name << ' ' << angle << ' ' << distance;
      }
    }
  }
}

}  // namespace
}  // namespace ghostforce::haply_kinematics_test
