// Distances off a ruler tell the angle at count zero and the gear, within the uncertainty that is said to be theirs.
#include "app/tools/doctor/ruler.h"
#include "core/conventions.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "device/falcon/kinematics.h"

namespace ghostforce::ruler_test {
namespace {

struct Way {
  Vector<3> from;
  Vector<3> to;
};
const std::vector<Way> ways{{{-0.03, 0, 0.125}, {0.03, 0, 0.125}},
                            {{-0.03, 0, 0.092}, {0.03, 0, 0.092}},
                            {{-0.03, 0, 0.153}, {0.03, 0, 0.153}},
                            {{0, -0.03, 0.125}, {0, 0.03, 0.125}},
                            {{0, 0, 0.095}, {0, 0, 0.155}}};

// Of a device that truly is like this, with a ruler that is off by so much [m].
std::vector<RulerReading> readings_of(const FalconGeometry& truth, double deviation, std::mt19937& random) {
  std::normal_distribution<double> off(0.0, 1.0);
  std::vector<RulerReading> readings;
  const FalconKinematics kinematics(truth);
  for (const Way& way : ways) {
    readings.push_back({.from = counts_of_angles(*kinematics.angles(way.from), truth),
                        .to = counts_of_angles(*kinematics.angles(way.to), truth),
                        .distance = glm::distance(way.from, way.to) + deviation * off(random)});
  }
  return readings;
}

FalconGeometry geometry_with(double degrees, double gear) {
  FalconGeometry geometry;
  geometry.angle_at_zero_count = degrees * radians_per_degree;
  geometry.gear_ratio = gear;
  return geometry;
}

TEST(Ruler, FindsWhatTheDeviceIs) {
  std::mt19937 random{1};
  for (const double degrees : {35.0, 40.0, 43.0, 50.0, -72.0}) {
    for (const double gear : {7.719, 7.4, 8.1}) {
      const FalconGeometry truth = geometry_with(degrees, gear);
      if (degrees < 0.0 && gear != 7.719) continue;
      const RulerFit fit = fit_ruler(readings_of(truth, 0.0, random), geometry_catalog().front(), true);
      ASSERT_TRUE(fit.is_found);
      EXPECT_NEAR(fit.angle_at_zero_count, truth.angle_at_zero_count, 1e-6);
      EXPECT_NEAR(fit.gear_ratio, gear, 1e-5);
      EXPECT_LT(fit.misfit, 1e-7);
    }
  }
}

// Two standard deviations hold 95 of 100; of 100, 88 or more is what chance leaves of that.
TEST(Ruler, IsAsUncertainAsItSays) {
  std::mt19937 random{2};
  const FalconGeometry truth = geometry_with(41.0, 7.9);
  int angles_within = 0;
  int gears_within = 0;
  for (int i = 0; i < 100; ++i) {
    const RulerFit fit =
        fit_ruler(readings_of(truth, 0.5 * ruler_uncertainty, random), geometry_catalog().front(), true);
    angles_within += std::abs(fit.angle_at_zero_count - truth.angle_at_zero_count) <= fit.angle_uncertainty ? 1 : 0;
    gears_within += std::abs(fit.gear_ratio - truth.gear_ratio) <= fit.gear_uncertainty ? 1 : 0;
    EXPECT_LT(fit.angle_uncertainty, 2.0 * radians_per_degree);
    EXPECT_LT(fit.gear_uncertainty / fit.gear_ratio, 0.02);
  }
  EXPECT_GE(angles_within, 88);
  EXPECT_GE(gears_within, 88);
}

TEST(Ruler, TakesWhatWasAssumedWhileTheRulerAllowsIt) {
  std::mt19937 random{3};
  const GeometryPreset& assumed = geometry_catalog().front();
  const RulerVerdict good = judge_rulers(readings_of(FalconGeometry{}, 0.0, random), assumed);
  EXPECT_TRUE(good.is_consistent);
  EXPECT_EQ(good.fit.preset, &assumed);
  EXPECT_NEAR(good.fit.angle_at_zero_count, assumed.geometry.angle_at_zero_count, good.fit.angle_uncertainty);
  EXPECT_FALSE(good.fit.has_gear);
  const RulerVerdict turned = judge_rulers(readings_of(geometry_with(40.0, 110.0 / 14.25), 0.0, random), assumed);
  EXPECT_GT(std::abs(turned.fit.angle_at_zero_count - assumed.geometry.angle_at_zero_count),
            turned.fit.angle_uncertainty);
  EXPECT_TRUE(turned.is_consistent);
  EXPECT_FALSE(turned.fit.has_gear);
  EXPECT_NEAR(turned.fit.angle_at_zero_count, 40.0 * radians_per_degree, 1e-6);
}

TEST(Ruler, SaysThatNothingFits) {
  std::mt19937 random{4};
  auto readings = readings_of(FalconGeometry{}, 0.0, random);
  readings[2].distance *= 0.7;
  EXPECT_FALSE(judge_rulers(readings, geometry_catalog().front()).is_consistent);
  for (RulerReading& reading : readings) reading.to = reading.from;  // nothing moved
  EXPECT_FALSE(judge_rulers(readings, geometry_catalog().front()).is_consistent);
}

}  // namespace
}  // namespace ghostforce::ruler_test
