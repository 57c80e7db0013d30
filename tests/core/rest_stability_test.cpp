#include "core/rest_stability.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/general_equilibrium.h"
#include "tests/core/general_scenes.h"

namespace ghostforce::rest_stability_test {
namespace {

// In a corner: the only place where the naïve handle's forces balance is one that it leaves.
Settings runaway_settings() {
  Settings settings = corner_settings();
  settings.wall_point = {0.128323202, 0.194323049};
  settings.general.corner_normal_angles = {229.708 / degrees_per_radian, 399.882 / degrees_per_radian};
  settings.general.mechanism = MechanismKind::arm;
  settings.general.arm = {
      {0.147694778, -0.328512943}, {0.09969, 0.609121}, TwoLinkArm::Elbow::left, TwoLinkArm::Motor::elbow};
  settings.stiffnesses.k_u = 88.151;
  settings.general.k_u_second = 406.478;
  settings.general.k_u_first_angle = 40.1 / degrees_per_radian;
  settings.stiffnesses.k_r = 520.496;
  settings.stiffnesses.k_t = 633.935;
  return settings;
}
const Vector<2> runaway_goal(0.095830415, 0.196179403);

// Round an obstacle: of three such places, the handle leaves the middle one.
Settings obstacle_settings() {
  Settings settings = curve_settings();
  settings.general.circle_radius = 0.010834;
  settings.general.circle_is_free_inside = false;
  settings.general.mechanism = MechanismKind::arm;
  settings.general.arm = {
      {-0.651658478, 0.143395603}, {0.990, 0.352052}, TwoLinkArm::Elbow::left, TwoLinkArm::Motor::elbow};
  settings.stiffnesses.k_u = 968.112;
  settings.stiffnesses.k_r = 1719.251;
  settings.stiffnesses.k_t = 783.108;
  settings.stiffnesses.k_c = no_limit;
  return settings;
}
const Vector<2> obstacle_goal(0.002888292, 0.001052106);

TickState<2> state_after(const GeneralCoefficients& coefficients, const Vector<2>& start, const Vector<2>& goal) {
  TickState<2> state = state_at_start(start);
  for (int k = 1; k <= 8000; ++k) tick(coefficients, glm::mix(start, goal, std::min(1.0, k / 1000.0)), state);
  return state;
}

TEST(RestStability, APlaceThatTheHandleLeavesIsNotToldAsItsRest) {
  const GeneralCoefficients coefficients = general_coefficients_of(runaway_settings());
  EXPECT_FALSE(general_equilibrium_of(StrategyId::naive, coefficients.scene, runaway_goal));
  const TickState<2> state = state_after(coefficients, {0.138164605, 0.184410969}, runaway_goal);
  for (const StrategyId id : {StrategyId::full, StrategyId::anisotropic}) {
    const auto rest = general_equilibrium_of(id, coefficients.scene, runaway_goal);
    ASSERT_TRUE(rest);
    EXPECT_LT(glm::length(state.strategies[index_of(id)].motion.position - rest->at.device), 1e-9);
    EXPECT_TRUE(
        leads_back(coefficients.scene, coefficients.scene.strategies[index_of(id)], rest->at.device, rest->at.proxy));
  }
  EXPECT_GT(glm::length(state.strategies[index_of(StrategyId::naive)].motion.position - runaway_goal), 0.1);
}

TEST(RestStability, WhereItLeavesOnePlaceTheOneThatItComesToIsTold) {
  const GeneralCoefficients coefficients = general_coefficients_of(obstacle_settings());
  const TickState<2> state = state_after(coefficients, {0.019575695, 0.007130759}, obstacle_goal);
  const auto& naive = state.strategies[index_of(StrategyId::naive)];
  const auto rest = general_equilibrium_of(StrategyId::naive, coefficients.scene, obstacle_goal);
  ASSERT_TRUE(rest);
  EXPECT_LT(glm::length(naive.motion.velocity), 1e-9);
  EXPECT_LT(glm::length(naive.motion.position - rest->at.device), 1e-7);
  const GeneralStrategy& own = coefficients.scene.strategies[index_of(StrategyId::naive)];
  EXPECT_TRUE(leads_back(coefficients.scene, own, rest->at.device, rest->at.proxy));
  // The place between.
  const Vector<2> left(0.00315253, 0.00099464);
  EXPECT_FALSE(leads_back(coefficients.scene, own, left, projection(coefficients.scene.constraint, left)));
}

TEST(RestStability, NothingHoldsAHandleThatTouchesNothing) {
  const GeneralScene scene = general_scene_of(arm_settings());
  EXPECT_FALSE(leads_back(scene, scene.strategies[index_of(StrategyId::naive)], {-0.02, 0.02}, {-0.02, 0.02}));
}

}  // namespace
}  // namespace ghostforce::rest_stability_test
