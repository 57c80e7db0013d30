#include "core/general_equilibrium.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/core/general_scenes.h"
#include "tests/core/random_setting.h"

namespace ghostforce::general_equilibrium_test {
namespace {

static_assert(std::is_trivially_copyable_v<GeneralEquilibrium>);
static_assert(noexcept(general_equilibrium_of(StrategyId::naive, std::declval<const GeneralScene&>(),
                                              std::declval<const Vector<2>&>())));

Settings random_settings(Random& random) {
  Settings settings = common_general_settings();
  settings.stiffnesses.k_u = random.uniform(50.0, 400.0);
  settings.stiffnesses.k_r = random.uniform(100.0, 800.0);
  settings.stiffnesses.k_t = random.uniform(100.0, 800.0);
  settings.stiffnesses.k_c = random.once_in(2) ? no_limit : 1e5;
  settings.wall_normal_angle = random.uniform(0.0, 6.28);
  settings.actuated_angle = random.uniform(0.0, 6.28);
  GeneralSettings& general = settings.general;
  if (random.once_in(2)) {
    general.k_u_second = random.uniform(50.0, 400.0);
    general.k_u_first_angle = random.uniform(0.0, 3.14);
  }
  general.constraint = static_cast<ConstraintKind>(random.below(3));
  general.corner_normal_angles[0] = random.uniform(0.0, 6.28);
  general.corner_normal_angles[1] = general.corner_normal_angles[0] + random.uniform(0.2, 2.9);
  general.circle_radius = random.uniform(0.03, 0.06);
  general.circle_is_free_inside = random.once_in(2);
  general.mechanism = static_cast<MechanismKind>(random.below(4));
  general.arm.base = 0.18 * direction_at(random.uniform(0.0, 6.28));
  general.arm.motor = random.once_in(2) ? TwoLinkArm::Motor::base : TwoLinkArm::Motor::elbow;
  general.pantograph = {{Vector<2>(-0.035, -0.17), Vector<2>(0.035, -0.17)},
                        0.11,
                        0.14,
                        random.once_in(2) ? FiveBar::Motor::left : FiveBar::Motor::right};
  general.strings.count = static_cast<std::uint32_t>(1 + random.below(4));
  for (Vector<2>& anchor : general.strings.anchors) anchor = 0.25 * direction_at(random.uniform(0.0, 6.28));
  if (random.once_in(3)) general.strings.most = random.uniform(0.3, 2.0);
  return settings;
}

// Where a random goal is behind the wall; the obstacle's face is then the nearest one.
Vector<2> random_goal(Random& random, const Settings& settings) {
  if (settings.general.constraint == ConstraintKind::circle) {
    const double radius = settings.general.circle_radius;
    return direction_at(random.uniform(0.0, 6.28)) *
           (settings.general.circle_is_free_inside ? radius + 0.01 : radius - 0.01);
  }
  return random.in_box<2>(0.02);
}

// The rest is told from the balance of the hand's spring, the distance of the proxy and the renderer's own answer there;
// none of them is how it was found.
TEST(GeneralEquilibrium, RestsStandStill) {
  int rests = 0;
  int without = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Random random(seed);
    Settings settings = random_settings(random);
    if (random.once_in(4)) settings.stiffnesses.believed_k_u = random.uniform(50.0, 400.0);
    if (random.once_in(4)) settings.general.compliance_share = random.uniform(0.0, 1.0);
    const GeneralCoefficients coefficients = general_coefficients_of(settings);
    const Vector<2> goal = random_goal(random, settings);
    if (!(signed_distance(coefficients.scene.constraint, goal) < -1e-4)) continue;
    const auto full = general_equilibrium_of(StrategyId::full, coefficients.scene, goal);
    if (!full) continue;  // out of the mechanism's reach
    for (const Strategy& each : strategy_catalog()) {
      const auto rest = general_equilibrium_of(each.id, coefficients.scene, goal);
      if (!rest) {
        EXPECT_NE(each.id, StrategyId::full);
        ++without;
        continue;
      }
      ++rests;
      TickState<2> state = state_at_start(goal);
      for (auto& own : state.strategies) {
        own.motion.position = rest->at.device;
        own.proxy = rest->at.proxy;
        own.force = rest->at.force;
      }
      tick(coefficients, goal, state);
      const auto& own = state.strategies[index_of(each.id)];
      EXPECT_LT(glm::length(own.motion.velocity) * coefficients.rate, 1e-9) << seed << " " << each.name;
      EXPECT_LT(glm::length(own.proxy - rest->at.proxy), 1e-11) << seed << " " << each.name;
      EXPECT_LT(glm::length(own.force - rest->at.force), 1e-8) << seed << " " << each.name;
      EXPECT_EQ(own.contact.active, rest->active) << seed << " " << each.name;
      for (std::size_t i = 0; i < motor_count(coefficients.scene.mechanism); ++i) {
        EXPECT_NEAR(own.contact.efforts[i], rest->efforts[i], 1e-7) << seed << " " << each.name;
      }
    }
  }
  EXPECT_GT(rests, 1000);
  EXPECT_LT(without, rests / 20);
}

// Where the loop comes to rest on its way from in front of the wall: the rest that is told, or none.
TEST(GeneralEquilibrium, TheLoopComesToTheRestThatIsTold) {
  int settled = 0;
  int restless = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Random random(seed);
    const Settings settings = random_settings(random);
    const GeneralCoefficients coefficients = general_coefficients_of(settings);
    const Constraint& constraint = coefficients.scene.constraint;
    const Vector<2> goal = random_goal(random, settings);
    if (!(signed_distance(constraint, goal) < -1e-4)) continue;
    if (!general_equilibrium_of(StrategyId::full, coefficients.scene, goal)) continue;
    const Vector<2> foot = projection(constraint, goal);
    const Vector<2> start = foot + 0.02 * glm::normalize(foot - goal);
    if (signed_distance(constraint, start) < 0.001 || !actuation_at(coefficients.scene.mechanism, start)) continue;
    TickState<2> state = state_at_start(start);
    for (int k = 1; k <= 8000; ++k) tick(coefficients, glm::mix(start, goal, std::min(1.0, k / 1000.0)), state);
    for (const Strategy& each : strategy_catalog()) {
      const auto rest = general_equilibrium_of(each.id, coefficients.scene, goal);
      const auto& own = state.strategies[index_of(each.id)];
      const double off = glm::length(coefficients.user_stiffness * (goal - own.motion.position) + own.force);
      const bool stands =
          off < 1e-6 && glm::length(own.motion.velocity) < 1e-7 && own.contact.status == ContactStatus::contact;
      if (!stands) {
        EXPECT_EQ(each.id, StrategyId::naive) << seed;
        restless += rest ? 1 : 0;
        continue;
      }
      ++settled;
      ASSERT_TRUE(rest) << seed << " " << each.name;
      EXPECT_LT(glm::length(own.motion.position - rest->at.device), 1e-7) << seed << " " << each.name;
      EXPECT_LT(glm::length(own.force - rest->at.force), 1e-5) << seed << " " << each.name;
    }
  }
  EXPECT_GT(settled, 900);
  EXPECT_EQ(restless, 0);
}

// A soft hand lets the motor carry the handle much farther than full actuation does: 83 mm here, with 20 between goal and
// edge.
TEST(GeneralEquilibrium, FarRestsOfASoftHandAreTold) {
  int settled = 0;
  int farthest_mm = 0;
  for (const double k_u : {20.0, 30.0, 60.0}) {
    for (int degrees = 0; degrees < 360; degrees += 10) {
      Settings settings = arm_settings();
      settings.stiffnesses.k_u = k_u;
      settings.wall_normal_angle = degrees / degrees_per_radian;
      const GeneralCoefficients coefficients = general_coefficients_of(settings);
      const Vector<2> goal = -0.02 * wall_of(settings).normal;
      TickState<2> state = state_at_start(-goal);
      for (int k = 1; k <= 12000; ++k) tick(coefficients, glm::mix(-goal, goal, std::min(1.0, k / 1000.0)), state);
      const auto& naive = state.strategies[index_of(StrategyId::naive)];
      const double off = glm::length(k_u * (goal - naive.motion.position) + naive.force);
      if (off > 1e-7 || naive.contact.status != ContactStatus::contact) continue;
      ++settled;
      const double away = glm::length(naive.motion.position - goal);
      farthest_mm = std::max(farthest_mm, static_cast<int>(away * 1e3));
      const auto rest = general_equilibrium_of(StrategyId::naive, coefficients.scene, goal);
      ASSERT_TRUE(rest) << k_u << " " << degrees << " " << away;
      EXPECT_LT(glm::length(naive.motion.position - rest->at.device), 1e-6) << k_u << " " << degrees << " " << away;
    }
  }
  EXPECT_GT(settled, 60);
  EXPECT_GT(farthest_mm, 80);
}

// Same proxy and same contact force as full actuation, whatever the mechanism, the corner, the circle and the hand; and
// every motor stands where it would stand with all motors on.
TEST(GeneralEquilibrium, TheCureRestsWithFullActuationsProxy) {
  int rests = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Random random(seed);
    const Settings settings = random_settings(random);
    const GeneralScene scene = general_scene_of(settings);
    const Vector<2> goal = random_goal(random, settings);
    if (!(signed_distance(scene.constraint, goal) < -1e-4)) continue;
    const auto full = general_equilibrium_of(StrategyId::full, scene, goal);
    if (!full) continue;
    const auto cured = general_equilibrium_of(StrategyId::anisotropic, scene, goal);
    if (!cured) {
      ADD_FAILURE() << seed;
      continue;
    }
    ++rests;
    EXPECT_LT(glm::length(cured->at.proxy - full->at.proxy), 1e-12) << seed;
    EXPECT_LT(glm::length(cured->contact_force - full->contact_force), 1e-9) << seed;
    if (settings.general.mechanism == MechanismKind::strings) continue;
    const auto actuation = actuation_at(scene.mechanism, cured->at.device);
    ASSERT_TRUE(actuation);
    const double along = glm::dot(glm::normalize(actuation->columns[0]), cured->at.device - full->at.device);
    EXPECT_NEAR(along, 0.0, 1e-13) << seed;
    // So the handle's place tells the goal.
    const Matrix<2> projector = actuated_projection(*actuation, 1, scene.compliances.user).projector;
    const Vector<2> best_force = scene.compliances.force_share * (projector * cured->contact_force);
    EXPECT_LT(glm::length(cured->at.device - scene.user_compliance * best_force - goal), 1e-13) << seed;
  }
  EXPECT_GT(rests, 500);
}

// Whatever the hand's ellipse, the fully actuated proxy inside a ring is the one point of it that is nearest to the
// goal in the compliance of hand and renderer together: no other point beside it is nearer, and the handle is where
// they say.
TEST(GeneralEquilibrium, InsideARingFullActuationAlwaysRests) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    Random random(seed);
    Settings settings = curve_settings();
    settings.stiffnesses.k_u = random.over_decades(20.0, 2000.0);
    settings.general.k_u_second = random.over_decades(20.0, 2000.0);
    settings.general.k_u_first_angle = random.uniform(0.0, 3.14);
    settings.stiffnesses.k_r = random.over_decades(30.0, 6000.0);
    settings.stiffnesses.k_t = settings.stiffnesses.k_r * random.over_decades(0.4, 2.5);
    settings.stiffnesses.k_c = no_limit;
    const GeneralScene scene = general_scene_of(settings);
    const double radius = settings.general.circle_radius;
    const Vector<2> goal = radius * random.uniform(1.01, 4.0) * direction_at(random.uniform(0.0, 6.28));
    const auto full = general_equilibrium_of(StrategyId::full, scene, goal);
    ASSERT_TRUE(full) << seed;
    const Vector<2>& proxy = full->at.proxy;
    EXPECT_NEAR(glm::length(proxy), radius, 1e-14) << seed;
    const Matrix<2> metric =
        glm::inverse(scene.compliances.tracking + scene.compliances.force_share * scene.user_compliance);
    const auto square = [&](const Vector<2>& p) { return glm::dot(p - goal, metric * (p - goal)); };
    const double angle = std::atan2(proxy.y, proxy.x);
    for (const double turn : {-2.0, -0.5, -0.1, -0.001, 0.001, 0.1, 0.5, 2.0}) {
      EXPECT_LT(square(proxy), square(radius * direction_at(angle + turn))) << seed;
    }
    const Vector<2> balance = full->at.device - scene.user_compliance * full->at.force - goal;
    EXPECT_LT(glm::length(balance), 1e-14) << seed;
    EXPECT_LT(glm::length(full->at.force - metric * (proxy - goal) * scene.compliances.force_share),
              1e-11 * (1.0 + glm::length(full->at.force)))
        << seed;
  }
}

// A belief that is wrong shows only across the motors: at rest the proxy has (Ĉ_u − C_u)(I − Π̂) more compliance.
TEST(GeneralEquilibrium, AWrongBeliefShowsAcrossTheMotorsAlone) {
  Settings settings = common_general_settings();
  settings.general.k_u_second = 120.0;
  settings.general.k_u_first_angle = 0.4;
  settings.stiffnesses.believed_k_u = 90.0;
  for (const double wall : {0.3, 2.0, 4.0}) {
    settings.wall_normal_angle = wall;
    const GeneralScene scene = general_scene_of(settings);
    const Vector<2> goal = -0.015 * direction_at(wall);
    const auto rest = general_equilibrium_of(StrategyId::anisotropic, scene, goal);
    ASSERT_TRUE(rest);
    const Matrix<2>& believed = scene.compliances.user;
    ActuationMatrix<2> axis;
    add_motor(axis, direction_at(settings.actuated_angle), direction_at(settings.actuated_angle));
    const Matrix<2> projector = actuated_projection(axis, 1, believed).projector;
    const Matrix<2> response = scene.user_compliance + Matrix<2>(1.0 / 600.0) +
                               (believed - scene.user_compliance) * (Matrix<2>(1.0) - projector);
    EXPECT_LT(glm::length(rest->at.proxy - (goal + response * rest->contact_force)), 1e-15);
  }
}

// The compliance share leads from naïve rendering to the cure.
TEST(GeneralEquilibrium, TheShareLeadsFromNaiveToTheCure) {
  for (Settings (*of)() : {arm_settings, pantograph_settings, corner_settings, string_settings}) {
    Settings settings = of();
    const Vector<2> goal(0.006, -0.016);
    const auto naive = general_equilibrium_of(StrategyId::naive, general_scene_of(settings), goal);
    const auto cured = general_equilibrium_of(StrategyId::anisotropic, general_scene_of(settings), goal);
    settings.general.compliance_share = 0.0;
    const auto none = general_equilibrium_of(StrategyId::anisotropic, general_scene_of(settings), goal);
    settings.general.compliance_share = 0.999999;
    const auto most = general_equilibrium_of(StrategyId::anisotropic, general_scene_of(settings), goal);
    ASSERT_TRUE(naive && cured && none && most);
    EXPECT_EQ(none->at.device, naive->at.device);
    EXPECT_EQ(none->at.force, naive->at.force);
    EXPECT_LT(glm::length(most->at.device - cured->at.device), 1e-7);
  }
}

TEST(GeneralEquilibrium, AGoalInFrontOfTheWallIsWhereEverythingRests) {
  const GeneralScene scene = general_scene_of(arm_settings());
  for (const Strategy& each : strategy_catalog()) {
    const auto rest = general_equilibrium_of(each.id, scene, Vector<2>(-0.02, 0.02));
    ASSERT_TRUE(rest);
    EXPECT_FALSE(rest->at.in_contact);
    EXPECT_EQ(rest->at.device, Vector<2>(-0.02, 0.02));
    EXPECT_EQ(rest->at.force, Vector<2>(0.0));
    EXPECT_EQ(rest->active, 0);
  }
}

// nᵀ(C_r + C_u A B)n + τ/k_c, where A is that of a pose, tells whether naïve rendering can rest near it: with a motor
// whose force and whose lever's motion enclose 45°, and κ = 10, for 18 % of the walls it cannot.
TEST(GeneralEquilibrium, NaiveRenderingHasNoRestBehindSomeWalls) {
  Settings settings = common_general_settings();
  settings.stiffnesses.k_u = 60.0;
  settings.general.mechanism = MechanismKind::arm;
  // Handle at the origin, 45° between the second link and the way that the base's motor moves the handle.
  const double link = 0.16;
  settings.general.arm = {{-link * std::sqrt(0.5) - link * std::sqrt(0.5), 0.0},
                          {link, link},
                          TwoLinkArm::Elbow::left,
                          TwoLinkArm::Motor::base};
  const double reach = glm::length(settings.general.arm.base);
  ASSERT_NEAR(reach, link * std::sqrt(2.0), 1e-12) << "a right angle at the elbow";
  int without = 0;
  constexpr int walls = 360;
  for (int i = 0; i < walls; ++i) {
    settings.wall_normal_angle = i * 2.0 * 3.14159265358979 / walls;
    const GeneralScene scene = general_scene_of(settings);
    // So shallow that the arm does not turn.
    const auto rest =
        general_equilibrium_of(StrategyId::naive, scene, -1e-7 * direction_at(settings.wall_normal_angle));
    // The handle runs away; behind a few walls to where the arm stands so differently that it can rest again.
    without += rest && glm::length(rest->at.device) < 0.005 ? 0 : 1;
  }
  EXPECT_NEAR(static_cast<double>(without) / walls, 0.18, 0.015);
}

}  // namespace
}  // namespace ghostforce::general_equilibrium_test
