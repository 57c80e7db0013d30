// The hand of a scene, measured by tones as fast as the machine can.
#include "core/hand_measurement.h"

#include <numbers>

#include <gtest/gtest.h>

namespace ghostforce::simulated_measurement_test {
namespace {

constexpr double longest_s = 6.0;

// A hand that holds its goal in a wall at 45°, under motors along x.
Scene held_in_wall(double k_u, StrategyId active) {
  Scene scene;
  scene.settings.wall_normal_angle = 0.75 * std::numbers::pi;
  scene.settings.mass = 0.1;
  scene.settings.damping = 5.0;
  scene.settings.rate = 1000.0;
  scene.settings.stiffnesses = {k_u, {}, 600.0, 600.0, 1e5, {}};
  scene.settings.active = active;
  scene.goal = {{Vector<2>(0.014, -0.014)}, {0.0}, Motion::linear};
  return scene;
}

TEST(SimulatedMeasurement, FindsTheGivenStiffnessUnderEachStrategy) {
  for (const Strategy& strategy : strategy_catalog()) {
    for (const double k_u : {80.0, 310.0, 900.0}) {
      SCOPED_TRACE(testing::Message() << strategy.name << ' ' << k_u);
      const Scene scene = held_in_wall(k_u, strategy.id);
      const HandEstimate hand = measure_simulated_hand(scene, 0.0, longest_s);
      ASSERT_TRUE(hand.is_known()) << sentence_of(hand.why);
      EXPECT_NEAR(hand.k_u, k_u, 0.005 * k_u);
      EXPECT_NEAR(hand.mass, scene.settings.mass, 0.02 * scene.settings.mass);
    }
  }
}

TEST(SimulatedMeasurement, AnotherHandIsFoundWhereItHasChanged) {
  Scene scene = held_in_wall(200.0, StrategyId::anisotropic);
  scene.stiffness_path = {{100.0, 100.0, 500.0}, {0.0, 9.0, 10.0}};
  EXPECT_NEAR(measure_simulated_hand(scene, 0.0, longest_s).k_u, 100.0, 0.005 * 100.0);
  EXPECT_NEAR(measure_simulated_hand(scene, 10.0, longest_s).k_u, 500.0, 0.005 * 500.0);
}

TEST(SimulatedMeasurement, SaysWhyNothingIsKnown) {
  Scene scene = held_in_wall(200.0, StrategyId::naive);
  EXPECT_EQ(measure_simulated_hand(scene, 0.0, 1.0).why, HandUnknown::collecting) << "it has not lasted";
  scene.goal.points.front() = Vector<2>(-0.014, 0.014);
  EXPECT_EQ(measure_simulated_hand(scene, 0.0, longest_s).why, HandUnknown::no_contact);
  scene = held_in_wall(200.0, StrategyId::naive);
  scene.settings.rate = 200.0;
  EXPECT_EQ(measure_simulated_hand(scene, 0.0, longest_s).why, HandUnknown::rate_too_low);
  scene = held_in_wall(200.0, StrategyId::naive);
  scene.tremor_and_drift = {.tremor_rms = 0.005, .tremor_hz = {2.0, 18.0}};
  EXPECT_FALSE(measure_simulated_hand(scene, 0.0, longest_s).is_known());
}

}  // namespace
}  // namespace ghostforce::simulated_measurement_test
