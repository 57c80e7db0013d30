// The landscape's closed form against the model's own, and the way from a set-up to its place on the map and back.
#include "app/state/landscape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "app/files/scene_file.h"
#include "core/conventions.h"
#include "core/ghost_force.h"
#include "core/scene.h"
#include "tests/app/stage/random_settings.h"

namespace ghostforce::landscape_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double right_angle = 0.5 * std::numbers::pi;

// By the model: at rest under a goal inside the wall, with the ratio that is asked for.
double share_by_model(const Settings& settings, double ratio) {
  const Wall<2> wall = wall_of(settings);
  const Actuation<2> actuation = actuation_of(settings);
  const Vector<2> goal = wall.point - 0.013 * wall.normal;
  const Vector<2> full = equilibrium_fully_actuated(wall, settings.stiffnesses, goal).force;
  const Vector<2> force = equilibrium_with_ratio(wall, actuation, settings.stiffnesses, ratio, goal).force;
  const Vector<2> ghost = ghost_force(actuation, force, full);
  // Too much is what goes on in the direction of the wall's push.
  return std::copysign(glm::length(ghost), glm::dot(ghost, wall.normal)) / glm::length(full);
}

double share_of(const Settings& settings, double dial) {
  return ghost_share(landscape_of(settings, dial), landscape_point(settings));
}

TEST(Landscape, KnowsTheNumbersOfWall45) {
  const Scene scene = load_scene("wall45");
  const LandscapePoint point = landscape_point(scene.settings);
  EXPECT_NEAR(point.angle, 45.0 * radians_per_degree, 1e-12);
  EXPECT_NEAR(point.kappa, 3.0, 1e-12);
  const double share = share_of(scene.settings, 0.0);
  EXPECT_NEAR(share, 0.42, 0.005);
  const double full = glm::length(equilibrium_of(StrategyId::full, scene.settings, scene.goal.points.back()).force);
  EXPECT_NEAR(full, 3.00, 0.005);
  EXPECT_NEAR(share * full, 1.27, 0.005);
}

TEST(Landscape, IsWhatTheModelComesToRestAt) {
  RandomSettings random(1);
  for (int i = 0; i < 2000; ++i) {
    const Settings settings = random.next();
    const double dial = i % 5 == 0 ? 0.0 : i % 5 == 1 ? 1.0 : random.between(0.0, 1.0);
    const double share = share_of(settings, dial);
    const double ratio = std::pow(tracking_ratio(settings.stiffnesses), dial);
    // The model takes a difference of forces of which each may be a hundred times as large.
    EXPECT_NEAR(share, share_by_model(settings, ratio), 1e-9 * std::max(1.0, std::abs(share))) << i;
  }
}

TEST(Landscape, IsNothingWhereTheBeliefIsRightAndTheDialTurned) {
  Settings settings = load_scene("wall45").settings;
  EXPECT_GT(ghost_share_range(landscape_of(settings, 0.0)).greatest, 4.0);
  const NumberRange range = ghost_share_range(landscape_of(settings, 1.0));
  EXPECT_NEAR(range.least, 0.0, 1e-12);
  EXPECT_NEAR(range.greatest, 0.0, 1e-12);
  settings.stiffnesses.believed_k_u = 400.0;
  EXPECT_GT(ghost_share_range(landscape_of(settings, 1.0)).greatest, 0.1) << "the ratio is too small";
  settings.stiffnesses.believed_k_u = 100.0;
  EXPECT_LT(ghost_share_range(landscape_of(settings, 1.0)).least, -0.1) << "the ratio is too great";
}

TEST(Landscape, AChosenRatioHoldsForEveryHand) {
  Settings settings = load_scene("wall45").settings;
  settings.stiffnesses.chosen_tracking_ratio = 7.0;
  const Landscape landscape = landscape_of(settings, 1.0);
  EXPECT_DOUBLE_EQ(landscape_ratio(landscape, 1.0), 7.0);
  EXPECT_DOUBLE_EQ(landscape_ratio(landscape, 100.0), 7.0);
  EXPECT_DOUBLE_EQ(landscape_ratio(landscape_of(settings, 0.0), 100.0), 1.0);
}

TEST(Landscape, IsFiniteAndOverMinusOneWhateverTheSettingsHold) {
  RandomSettings random(2);
  for (int i = 0; i < 5000; ++i) {
    const Landscape landscape = landscape_of(random.hostile(), random.coin() ? random.hostile_number() : 1.0);
    const LandscapePoint point{random.coin() ? random.hostile_number() : right_angle,
                               random.coin() ? random.hostile_number() : random.between(1.0, 100.0)};
    const double share = ghost_share(landscape, point);
    EXPECT_TRUE(std::isfinite(share)) << i;
    EXPECT_GE(share, -1.0) << i;
    const NumberRange range = ghost_share_range(landscape);
    EXPECT_TRUE(std::isfinite(range.least) && std::isfinite(range.greatest)) << i;
  }
}

TEST(Landscape, IsNothingAtBothEndsOfTheAngle) {
  Settings settings = load_scene("wall45").settings;
  for (const double k_c : {1e5, infinity}) {
    settings.stiffnesses.k_c = k_c;
    for (const double kappa : {1.0, 100.0}) {
      EXPECT_EQ(ghost_share(landscape_of(settings, 0.0), {0.0, kappa}), 0.0);
      EXPECT_NEAR(ghost_share(landscape_of(settings, 0.0), {right_angle, kappa}), 0.0, 1e-13);
    }
  }
}

// ---- To the map and back ----------------------------------------------------------------------------------------------

TEST(LandscapePoint, FoldsTheAngleBetweenNormalAndMotor) {
  Settings settings = load_scene("wall45").settings;
  const auto angle_at = [&](double normal_deg, double actuated_deg) {
    settings.wall_normal_angle = normal_deg * radians_per_degree;
    settings.actuated_angle = actuated_deg * radians_per_degree;
    return landscape_point(settings).angle * degrees_per_radian;
  };
  EXPECT_NEAR(angle_at(30.0, 0.0), 30.0, 1e-9);
  EXPECT_NEAR(angle_at(150.0, 0.0), 30.0, 1e-9);
  EXPECT_NEAR(angle_at(-30.0, 0.0), 30.0, 1e-9);
  EXPECT_NEAR(angle_at(210.0, 0.0), 30.0, 1e-9);
  EXPECT_NEAR(angle_at(90.0, 0.0), 90.0, 1e-9);
  EXPECT_NEAR(angle_at(0.0, 180.0), 0.0, 1e-9);
  EXPECT_NEAR(angle_at(495.0, 20.0), 65.0, 1e-9);
}

TEST(LandscapePoint, ASetUpStaysAsItIsAtItsOwnPlace) {
  RandomSettings random(3);
  for (int i = 0; i < 500; ++i) {
    const Settings settings = random.next();
    EXPECT_EQ(with_landscape_point(settings, landscape_point(settings)), settings) << i;
  }
}

TEST(LandscapePoint, ASetUpComesToWhereItIsWanted) {
  RandomSettings random(4);
  for (int i = 0; i < 1000; ++i) {
    const Settings settings = random.next();
    const LandscapePoint wanted{random.between(0.0, right_angle), std::pow(10.0, random.between(0.0, 2.0))};
    const Settings moved = with_landscape_point(settings, wanted);
    const LandscapePoint point = landscape_point(moved);
    EXPECT_NEAR(point.angle, wanted.angle, 2e-6) << i << ": but for the margin at 0° and 90°";
    EXPECT_NEAR(point.kappa, wanted.kappa, 1e-9 * wanted.kappa) << i;
    EXPECT_EQ(landscape_of(moved, 0.0).softness, landscape_of(settings, 0.0).softness) << i << ": the map moves";
    // Nothing else changes.
    Settings back = moved;
    back.wall_normal_angle = settings.wall_normal_angle;
    back.stiffnesses.k_r = settings.stiffnesses.k_r;
    EXPECT_EQ(back, settings) << i;
  }
}

TEST(LandscapePoint, TheWallNeverFlipsWhileOneDrags) {
  for (const double start_deg : {20.0, 160.0, -20.0, -160.0, 380.0}) {
    Settings settings = load_scene("wall45").settings;
    settings.actuated_angle = 0.1;
    settings.wall_normal_angle = 0.1 + start_deg * radians_per_degree;
    const double start = settings.wall_normal_angle;
    double before = start;
    // To 0°, where the pointer leaves the map, to 90°, likewise, and home again.
    for (int step = 0; step <= 180; ++step) {
      const double degrees = step <= 30 ? 20.0 - step : step <= 140 ? step - 40.0 : 130.0 - (step - 140) * 2.75;
      settings = with_landscape_point(settings, {degrees * radians_per_degree, 3.0});
      EXPECT_LT(std::abs(settings.wall_normal_angle - before), 3.0 * radians_per_degree) << start_deg << ' ' << step;
      before = settings.wall_normal_angle;
    }
    EXPECT_NEAR(settings.wall_normal_angle, start, 1e-9) << start_deg;
  }
}

TEST(LandscapePoint, KeepsToWhatASceneMayHold) {
  RandomSettings random(5);
  for (int i = 0; i < 1000; ++i) {
    Settings settings = random.next();
    settings.stiffnesses.k_u = user_stiffness_range.nearest_to(std::pow(10.0, random.between(-2.0, 7.0)));
    settings.stiffnesses.k_r = random.coin() ? 0.0 : std::pow(10.0, random.between(-6.0, 6.0));
    settings.stiffnesses.k_t = std::pow(10.0, random.between(-1.0, 6.0));
    settings.stiffnesses.believed_k_u.reset();
    ASSERT_TRUE(is_in_range(settings)) << i;
    const LandscapePoint wanted{random.between(0.0, right_angle), std::pow(10.0, random.between(0.0, 2.0))};
    EXPECT_TRUE(is_in_range(with_landscape_point(settings, wanted))) << i;
  }
}

TEST(LandscapePoint, IsFiniteWhateverTheSettingsHold) {
  RandomSettings random(6);
  for (int i = 0; i < 2000; ++i) {
    const LandscapePoint point = landscape_point(random.hostile());
    EXPECT_TRUE(std::isfinite(point.angle) && std::isfinite(point.kappa)) << i;
    EXPECT_TRUE(point.angle >= 0.0 && point.angle <= right_angle && point.kappa >= 0.0) << i;
    const Settings settings = random.next();
    const Settings moved = with_landscape_point(settings, {random.hostile_number(), random.hostile_number()});
    EXPECT_TRUE(is_in_range(moved)) << i;
  }
}

}  // namespace
}  // namespace ghostforce::landscape_test
