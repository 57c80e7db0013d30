// The catalog of geometries, and counts as angles.
#include "device/falcon/geometry.h"
#include "core/conventions.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

#include "device/falcon/kinematics.h"

namespace ghostforce::geometry_test {
namespace {

TEST(GeometryCatalog, BeginsWithTheDefault) {
  ASSERT_FALSE(geometry_catalog().empty());
  EXPECT_EQ(geometry_catalog().front().geometry, FalconGeometry{});
}

TEST(GeometryCatalog, HasNamesOfItsOwn) {
  std::set<std::string_view> names;
  for (const GeometryPreset& preset : geometry_catalog()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    EXPECT_TRUE(preset.sentence.ends_with('.')) << preset.name;
  }
  EXPECT_FALSE(names.contains(""));
}

// A wrong sign of an offset still solves, somewhere else.
TEST(GeometryCatalog, EveryGeometryReachesTheWorkspaceOfAFalcon) {
  for (const GeometryPreset& preset : geometry_catalog()) {
    SCOPED_TRACE(preset.name);
    const FalconKinematics kinematics(preset.geometry);
    double most = 0.0;
    for (double z = 0.075; z < 0.1755; z += 0.005) {
      // Pushed all the way in or pulled all the way out, a handle is near the axis.
      const double radius = z > 0.0845 && z < 0.1605 ? 0.050 : 0.0;
      for (double direction = 0.0; direction < 2.0 * std::numbers::pi; direction += 0.1) {
        const Vector<3> p(radius * std::cos(direction), radius * std::sin(direction), z);
        const auto angles = kinematics.angles(p);
        ASSERT_TRUE(angles) << p.x << ' ' << p.y << ' ' << p.z;
        const Vector<3> counts = counts_of_angles(*angles, preset.geometry);
        for (glm::length_t i = 0; i < 3; ++i) most = std::max(most, std::abs(counts[i]));
      }
    }
    // Encoders of real devices were seen up to about 1600 either way; another zero and other lengths are 30° more.
    EXPECT_LT(most, 2400.0);
    EXPECT_GT(most, 1600.0);
  }
}

// Three equal angles put the handle on the axis, and a device that is just homed has them.
TEST(GeometryCatalog, EveryGeometryPutsAHomedHandleOnTheAxis) {
  for (const GeometryPreset& preset : geometry_catalog()) {
    SCOPED_TRACE(preset.name);
    const FalconKinematics kinematics(preset.geometry);
    const auto homed = kinematics.position(angles_of_counts(Vector<3>(0.0), preset.geometry));
    ASSERT_TRUE(homed.has_converged);
    // What Newton leaves.
    EXPECT_NEAR(homed.position.x, 0.0, 1e-12);
    EXPECT_NEAR(homed.position.y, 0.0, 1e-12);
    EXPECT_GT(homed.position.z, 0.13);
    EXPECT_LT(homed.position.z, 0.15);
  }
}

TEST(FalconGeometry, CountsAreWorthWhatThePublishedNumbersSay) {
  // Half of the last digit published.
  EXPECT_NEAR(radians_per_count(FalconGeometry{}) * 1e3, 0.63590, 0.000005);
  EXPECT_NEAR(radians_per_count(FalconGeometry{}) / radians_per_degree, 0.036435, 0.0000005);
  const GeometryPreset& martin_hillier = geometry_catalog()[2];
  ASSERT_EQ(martin_hillier.name, "martin-hillier");
  EXPECT_NEAR(radians_per_count(martin_hillier.geometry) / radians_per_degree, 0.03691, 0.000005);
}

TEST(FalconGeometry, CountsGrowWithTheAngleFromTheZero) {
  const FalconGeometry geometry;
  const Vector<3> angles = angles_of_counts({0.0, 1.0, -1000.0}, geometry);
  EXPECT_EQ(angles.x, geometry.angle_at_zero_count);
  EXPECT_GT(angles.y, angles.x);
  EXPECT_LT(angles.z, angles.x);
}

TEST(FalconGeometry, AnglesOfCountsAndBack) {
  for (const GeometryPreset& preset : geometry_catalog()) {
    for (double count = -32768.0; count <= 32767.0; count += 1.0) {
      const Vector<3> counts(count, -count, 0.5 * count);
      const Vector<3> back = counts_of_angles(angles_of_counts(counts, preset.geometry), preset.geometry);
      // Angles up to 21 rad, and counts that are 1600 to the radian: a few roundings of 3e4.
      for (glm::length_t i = 0; i < 3; ++i) ASSERT_NEAR(back[i], counts[i], 4.0 * 3e4 * 2.3e-16);
    }
  }
}

}  // namespace
}  // namespace ghostforce::geometry_test
