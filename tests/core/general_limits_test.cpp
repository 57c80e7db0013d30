// What the law for any device cannot do, and what goes wrong without it: the limits that docs/theory.md tells, each with
// numbers.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/general_equilibrium.h"
#include "tests/core/general_scenes.h"
#include "tests/core/random_setting.h"

namespace ghostforce::general_limits_test {
namespace {

// Of a force or of a difference of forces [N], in the energy of the hand.
double energy_norm(const GeneralScene& scene, const Vector<2>& force) {
  return std::sqrt(glm::dot(force, scene.user_compliance * force));
}

// The linear law, whose strings would have to push, with what they cannot do cut off. At the handle's true rest it gives
// another force, so the handle does not rest there.
TEST(GeneralLimits, CuttingNegativeTensionsOffIsNotTheBestThatStringsCanDo) {
  std::vector<double> errors;
  int without_rest = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    Settings settings = string_settings();
    settings.wall_normal_angle = random.uniform(0.0, 6.28);
    settings.general.k_u_second = random.uniform(50.0, 400.0);
    settings.general.k_u_first_angle = random.uniform(0.0, 3.14);
    for (Vector<2>& anchor : settings.general.strings.anchors) anchor = 0.25 * direction_at(random.uniform(0.0, 6.28));
    const GeneralScene scene = general_scene_of(settings);
    const Vector<2> goal = -0.02 * wall_of(settings).normal;
    const auto full = general_equilibrium_of(StrategyId::full, scene, goal);
    const auto rest = general_equilibrium_of(StrategyId::anisotropic, scene, goal);
    ASSERT_TRUE(full) << seed;
    if (!rest) {
      const ActuationMatrix<2> pulls = *actuation_at(scene.mechanism, goal);
      EXPECT_LT(glm::dot(pulls.columns[0], pulls.columns[1]), -0.95) << seed << ": they pull against each other";
      ++without_rest;
      continue;
    }
    const ActuationMatrix<2> strings = *actuation_at(scene.mechanism, rest->at.device);
    ActuationMatrix<2> rods = strings;  // that push as well as they pull
    for (double& least : rods.least) least = -no_limit;
    const Planes<2> wall = linearised(scene.constraint, rest->at.proxy);
    Contact<2> linear = solve_contact(rest->at.device, wall, rods, scene.compliances, 1.0);
    const bool would_push = *std::min_element(linear.efforts.begin(), linear.efforts.begin() + rods.count) < 0.0;
    for (std::size_t i = 0; i < strings.count; ++i) linear.efforts[i] = within_limits(strings, i, linear.efforts[i]);
    const Vector<2> off = force_of_efforts(strings, linear.efforts) - rest->at.force;
    if (would_push) {
      errors.push_back(energy_norm(scene, off) / energy_norm(scene, full->at.force));
    } else {
      EXPECT_LT(glm::length(off), 1e-10) << seed << ": where none would push, both are the same";
    }
  }
  EXPECT_LT(without_rest, 5);
  ASSERT_GT(errors.size(), 100U);
  std::ranges::sort(errors);
  EXPECT_GT(errors[errors.size() / 2], 0.1) << "of the push of full actuation";
  EXPECT_GT(errors.back(), 0.5);
}

// The proxy of a corner, found wall by wall in the metric of C_t, or as the nearest point in millimetres: neither is that
// of full actuation, which the law has.
TEST(GeneralLimits, WallByWallOrInPlainDistanceACornerGivesAnotherForce) {
  int by_walls = 0;
  int by_distance = 0;
  int cases = 0;
  for (std::uint64_t seed = 0; seed < 800; ++seed) {
    Random random(seed);
    Settings settings = corner_settings();
    settings.stiffnesses.k_c = no_limit;
    settings.actuated_angle = random.uniform(0.0, 3.14);
    settings.general.corner_normal_angles[0] = random.uniform(0.0, 6.28);
    settings.general.corner_normal_angles[1] = settings.general.corner_normal_angles[0] + random.uniform(0.4, 2.6);
    const GeneralScene scene = general_scene_of(settings);
    const CornerWall corner = std::get<CornerWall>(scene.constraint);
    const auto behind = [&](const Vector<2>& q, std::size_t i) { return -glm::dot(q, corner.normals[i]); };
    const Vector<2> goal = random.in_box<2>(0.03);
    const auto full = general_equilibrium_of(StrategyId::full, scene, goal);
    const auto rest = general_equilibrium_of(StrategyId::anisotropic, scene, goal);
    ASSERT_TRUE(full && rest);
    const Vector<2>& device = rest->at.device;
    if (behind(device, 0) <= 0.0 || behind(device, 1) <= 0.0) continue;  // in front of one, there is no order to choose
    ++cases;
    EXPECT_LT(glm::length(rest->at.proxy - full->at.proxy), 1e-14) << seed;
    const ActuationMatrix<2> actuation = *actuation_at(scene.mechanism, device);
    const Matrix<2> projector = actuated_projection(actuation, all_motors(1), scene.compliances.user).projector;
    const Matrix<2> tracking = tracking_compliance(scene.compliances, projector, 1.0);
    const auto error_of = [&](const Vector<2>& proxy) {
      const Vector<2> contact = glm::inverse(tracking) * (proxy - device);
      const Vector<2> force = scene.compliances.force_share * (projector * contact);
      return glm::length(force - rest->at.force) / glm::length(full->at.force);
    };
    EXPECT_LT(error_of(rest->at.proxy), 1e-9);
    Vector<2> proxy = device;
    for (std::size_t i = 0; i < 2; ++i) {
      const Vector<2> moved = tracking * corner.normals[i];
      proxy += moved * (std::max(0.0, behind(proxy, i)) / glm::dot(corner.normals[i], moved));
    }
    by_walls += error_of(proxy) > 0.1 ? 1 : 0;
    by_distance += error_of(projection(scene.constraint, device)) > 0.1 ? 1 : 0;
  }
  ASSERT_GT(cases, 100);
  EXPECT_GT(by_walls, cases / 4);
  EXPECT_GT(by_distance, cases / 4);
}

// A motor feels how far the hand yields along it, aᵀC_u a. Two hands that are equal there want different laws, and what
// is measured along the motor, taken for the stiffness in all directions, is right for one of them alone.
TEST(GeneralLimits, WhatIsMeasuredAlongTheMotorDoesNotTellWhatTheLawNeeds) {
  const auto rest_of_hand = [](double k_u_across, bool is_believed_round) {
    Settings settings = common_general_settings();
    settings.wall_normal_angle = 135.0 / degrees_per_radian;
    settings.general.k_u_second = k_u_across;
    const GeneralScene true_hand = general_scene_of(settings);
    const Vector<2> motor = direction_at(settings.actuated_angle);
    const double measured = 1.0 / glm::dot(motor, true_hand.user_compliance * motor);
    EXPECT_NEAR(measured, 200.0, 1e-12) << "whatever the hand is across it";
    if (is_believed_round) settings.stiffnesses.believed_k_u = measured;
    return *predicted_general_equilibria(general_scene_of(settings),
                                         Vector<2>(0.014, -0.014))[index_of(StrategyId::anisotropic)];
  };
  for (const double k_u_across : {60.0, 200.0, 600.0}) {
    EXPECT_LT(glm::length(rest_of_hand(k_u_across, false).ghost_force), 1e-12);
    const double ghost = glm::length(rest_of_hand(k_u_across, true).ghost_force);
    EXPECT_EQ(ghost < 1e-12, k_u_across == 200.0) << ghost;
    EXPECT_TRUE(ghost < 1e-12 || ghost > 0.2) << ghost;
  }
}

// Where the handle rests under a torque that does not follow it; empty: it finds no rest.
std::optional<Vector<2>> rest_under_torque(const GeneralScene& scene, const Vector<2>& goal, double torque) {
  Vector<2> q = goal;
  for (int i = 0; i < 500; ++i) {
    const auto actuation = actuation_at(scene.mechanism, q);
    if (!actuation) return std::nullopt;
    const Vector<2> next = goal + scene.user_compliance * (actuation->columns[0] * torque);
    if (glm::length(next - q) < 1e-15) return next;
    q = glm::mix(q, next, 0.5);
  }
  return std::nullopt;
}

// The law takes A as it is at the rest. The best of all constant torques knows that A turns on the way there, and yet
// leaves the handle hardly nearer to where full actuation holds it, in the energy of the hand.
TEST(GeneralLimits, TheBestTorqueForAnArmThatTurnsIsHardlyBetter) {
  double worst = 0.0;
  int cases = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    Settings settings = arm_settings();
    settings.general.arm.base = random.uniform(0.15, 0.30) * direction_at(random.uniform(0.0, 6.28));
    settings.general.arm.motor = random.once_in(2) ? TwoLinkArm::Motor::base : TwoLinkArm::Motor::elbow;
    settings.wall_normal_angle = random.uniform(0.0, 6.28);
    const GeneralScene scene = general_scene_of(settings);
    const Vector<2> goal = -0.02 * wall_of(settings).normal;
    const auto full = general_equilibrium_of(StrategyId::full, scene, goal);
    const auto rest = general_equilibrium_of(StrategyId::anisotropic, scene, goal);
    if (!full || !rest) continue;
    const auto distance = [&](const Vector<2>& q) {
      const Vector<2> off = q - full->at.device;
      return std::sqrt(glm::dot(off, glm::inverse(scene.user_compliance) * off));
    };
    const double at_rest = distance(rest->at.device);
    if (at_rest < 0.05 * distance(goal)) continue;  // straight at the motor, where a share of it means nothing
    ++cases;
    double nearest = at_rest;
    for (int i = -200; i <= 200; ++i) {
      const auto other = rest_under_torque(scene, goal, rest->efforts[0] * (1.0 + 0.002 * i));
      if (other) nearest = std::min(nearest, distance(*other));
    }
    worst = std::max(worst, at_rest / nearest - 1.0);
  }
  EXPECT_GT(cases, 200);
  EXPECT_LT(worst, 0.02);
  EXPECT_GT(worst, 1e-4) << "but it is better";
}

TEST(GeneralLimits, NearTheEdgeOfTheWorkspaceTheCureMayHaveNoRest) {
  const GeneralCoefficients coefficients = general_coefficients_of(with_arm_near_edge(arm_settings()));
  const Vector<2> start(-0.004817934, 0.002419061);
  const Vector<2> goal = goal_near_edge;
  EXPECT_TRUE(general_equilibrium_of(StrategyId::full, coefficients.scene, goal));
  EXPECT_FALSE(general_equilibrium_of(StrategyId::anisotropic, coefficients.scene, goal));
  TickState<2> state = state_at_start(start);
  for (int k = 1; k <= 6000; ++k) tick(coefficients, glm::mix(start, goal, std::min(1.0, k / 1000.0)), state);
  const auto& cured = state.strategies[index_of(StrategyId::anisotropic)];
  const Vector<2> balance = coefficients.user_stiffness * (goal - cured.motion.position) + cured.force;
  EXPECT_FALSE(glm::length(balance) < 1e-3 && cured.contact.status == ContactStatus::contact);
}

// Two strings pull against each other, two degrees out of line. Across them the law still asks for the wall's push, and
// that takes dozens of times as much tension.
TEST(GeneralLimits, StringsAllButInLineAreAskedForLargeTensions) {
  Settings settings = string_settings();
  settings.wall_normal_angle = 90.0 / degrees_per_radian;
  const double aside = 0.3 * std::sin(1.0 / degrees_per_radian);
  settings.general.strings.anchors = {Vector<2>(-0.3, aside), Vector<2>(0.3, aside)};
  const GeneralScene scene = general_scene_of(settings);
  const Vector<2> handle(0.0, 0.0);
  const Contact<2> contact = solve_contact(handle, linearised(Wall<2>{{0.0, 0.01}, {0.0, 1.0}}, handle),
                                           *actuation_at(scene.mechanism, handle), scene.compliances, 1.0);
  EXPECT_GT(glm::length(contact.force), 1.0);
  EXPECT_GT(contact.efforts[0], 25.0 * glm::length(contact.force));
  EXPECT_NEAR(contact.efforts[0], contact.efforts[1], 1e-9);
}

// Fully actuated round an obstacle, hand and wall balance at the far face too. The slightest push ends that; what is told
// is the rest at the face nearest to the goal.
TEST(GeneralLimits, RoundAnObstacleTheFaceNearestToTheGoalIsTold) {
  Settings settings = curve_settings();
  settings.general.circle_is_free_inside = false;
  const GeneralCoefficients coefficients = general_coefficients_of(settings);
  const double radius = settings.general.circle_radius;
  const Vector<2> out = direction_at(0.7);
  const Vector<2> goal = (radius - 0.01) * out;
  const auto told = general_equilibrium_of(StrategyId::full, coefficients.scene, goal);
  ASSERT_TRUE(told);
  EXPECT_LT(glm::length(glm::normalize(told->at.proxy) - out), 1e-12);

  const Stiffnesses& all = settings.stiffnesses;
  const double push = (radius + glm::length(goal)) / (1.0 / all.k_u + 1.0 / all.k_r + 1.0 / all.k_c);
  const auto state_beside_far_rest = [&](double aside) {
    TickState<2> state = state_at_start(goal);
    auto& own = state.strategies[index_of(StrategyId::full)];
    own.force = -push * out;
    own.motion.position = goal - (push / all.k_u) * out + aside * Vector<2>(-out.y, out.x);
    own.proxy = goal - (push / all.k_u + push / all.k_r) * out;
    return state;
  };
  TickState<2> balanced = state_beside_far_rest(0.0);
  tick(coefficients, goal, balanced);
  EXPECT_LT(glm::length(balanced.strategies[index_of(StrategyId::full)].motion.velocity), 1e-12);
  TickState<2> pushed = state_beside_far_rest(1e-4);
  for (int k = 0; k < 20000; ++k) tick(coefficients, goal, pushed);
  EXPECT_LT(glm::length(pushed.strategies[index_of(StrategyId::full)].motion.position - told->at.device), 1e-9);
}

// Naïve, the same hand at the same place comes to rest at one wall or in the corner, as it was led there; told is the
// one that full actuation's rest becomes, at that wall.
TEST(GeneralLimits, NaiveRenderingMayHaveTwoRestsInACorner) {
  Settings settings = corner_settings();
  settings.general.corner_normal_angles = {77.9 / degrees_per_radian, 108.3 / degrees_per_radian};
  settings.general.mechanism = MechanismKind::arm;
  settings.general.arm = {{-0.1025, 0.2346}, {0.160, 0.160}, TwoLinkArm::Elbow::left, TwoLinkArm::Motor::elbow};
  const GeneralCoefficients coefficients = general_coefficients_of(settings);
  const Vector<2> goal(-0.0133, -0.0198);
  const auto rest_by_way_of = [&](const Vector<2>& waypoint) {
    const Vector<2> start(0.0, 0.02);
    TickState<2> state = state_at_start(start);
    for (int k = 1; k <= 1000; ++k) tick(coefficients, glm::mix(start, waypoint, k / 1000.0), state);
    for (int k = 1; k <= 1000; ++k) tick(coefficients, glm::mix(waypoint, goal, k / 1000.0), state);
    for (int k = 1; k <= 5000; ++k) tick(coefficients, goal, state);
    const auto& naive = state.strategies[index_of(StrategyId::naive)];
    EXPECT_LT(glm::length(naive.motion.velocity), 1e-9);
    return std::pair(naive.motion.position, naive.contact.active);
  };
  const auto [at_wall, one_wall] = rest_by_way_of(goal);
  const auto [in_corner, both_walls] = rest_by_way_of(Vector<2>(0.013, -0.040));
  EXPECT_EQ(one_wall, 1);
  EXPECT_EQ(both_walls, 3);
  EXPECT_GT(glm::length(in_corner - at_wall), 0.02);
  const auto full = general_equilibrium_of(StrategyId::full, coefficients.scene, goal);
  const auto told = general_equilibrium_of(StrategyId::naive, coefficients.scene, goal);
  ASSERT_TRUE(full && told);
  EXPECT_EQ(full->active, one_wall);
  EXPECT_LT(glm::length(told->at.device - at_wall), 1e-7);
}

}  // namespace
}  // namespace ghostforce::general_limits_test
