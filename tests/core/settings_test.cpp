#include "core/settings.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "tests/core/random_setting.h"

namespace ghostforce::settings_test {
namespace {

constexpr double degrees = std::numbers::pi / 180.0;
constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();  // cosines and products of two of them

Settings example() {
  Settings settings;
  settings.wall_point = {0.01, -0.02};
  settings.wall_normal_angle = 135.0 * degrees;
  settings.actuated_angle = 30.0 * degrees;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses = make_stiffnesses(100.0, 1000.0, 500.0, 1e5);
  return settings;
}

TEST(SettingsTest, AnglesAreDirectionsCounterClockwiseFromX) {
  const Wall<2> wall = wall_of(example());
  EXPECT_EQ(wall.point, Vector<2>(0.01, -0.02));
  EXPECT_LE(glm::length(wall.normal - Vector<2>(-1.0, 1.0) / std::numbers::sqrt2), rounding);
  const Vector<2> motor{std::sqrt(3.0) / 2.0, 0.5};
  EXPECT_LE(glm::length(actuation_of(example()).actuated * motor - motor), rounding);
  EXPECT_LE(glm::length(actuation_of(example()).actuated * Vector<2>(-motor.y, motor.x)), rounding);
}

TEST(SettingsTest, CoefficientsHoldWhatATickNeeds) {
  const TickCoefficients<2> coefficients = coefficients_of(example());
  EXPECT_EQ(coefficients.wall.point, wall_of(example()).point);
  EXPECT_EQ(coefficients.wall.normal, wall_of(example()).normal);
  EXPECT_EQ(coefficients.actuation.actuated, actuation_of(example()).actuated);
  EXPECT_EQ(coefficients.device.mass, 0.1);
  EXPECT_EQ(coefficients.device.damping, 5.0);
  EXPECT_EQ(coefficients.device.user_stiffness, 100.0);
  EXPECT_EQ(coefficients.device.period, 0.001);
  EXPECT_EQ(coefficients.rate, 1000.0);
}

TEST(SettingsTest, DifferWhereAnyOfThemDiffers) {
  EXPECT_EQ(example(), example());
  Settings other = example();
  other.stiffnesses.believed_k_u = 100.0;  // the same number as k_u, but a belief of its own
  EXPECT_NE(other, example());
  other = example();
  other.active = StrategyId::naive;
  EXPECT_NE(other, example());
}

static_assert(std::is_trivially_copyable_v<Settings>);
static_assert(noexcept(coefficients_of(std::declval<const Settings&>())));

}  // namespace
}  // namespace ghostforce::settings_test
