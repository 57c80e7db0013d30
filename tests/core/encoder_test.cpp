#include "core/sampled_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "core/settings.h"
#include "tests/core/random_setting.h"

namespace ghostforce::encoder_test {
namespace {

Settings settings_with_encoder(double step) {
  Settings settings;
  settings.wall_normal_angle = 2.0;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses = make_stiffnesses(200.0, 600.0, 600.0, 1e5);
  settings.encoder_step = step;
  return settings;
}

TEST(EncoderTest, CountsTheNearestStep) {
  const Vector<2> measured = measured_position(0.5, Vector<2>(0.74, -0.76));
  EXPECT_EQ(measured, Vector<2>(0.5, -1.0));
  EXPECT_EQ(measured_position(0.5, Vector<2>(1.5, -2.0)), Vector<2>(1.5, -2.0)) << "on a step";
  const Vector<3> place(0.1, 0.2, 0.3);
  const Vector<3> near = measured_position(60e-6, place);
  for (glm::length_t i = 0; i < 3; ++i) EXPECT_LE(std::abs(near[i] - place[i]), 30.001e-6);
}

TEST(EncoderTest, WithoutOneThePlaceIsExact) {
  const Vector<2> place(-0.0, 0.1 + 0.2);
  const Vector<2> measured = measured_position(0.0, place);
  EXPECT_EQ(measured, place);
  EXPECT_TRUE(std::signbit(measured.x));
  EXPECT_EQ(measured_position(settings_with_encoder(0.5), Vector<2>(0.74, 0.0)), Vector<2>(0.5, 0.0));
}

// (25) and (5) with the place that is seen, (23) (24) with the place that is: tick by tick by hand, in and out of the
// wall, to the last bit, for all strategies.
TEST(EncoderTest, TheRendererSeesStepsAndTheDeviceMovesFreely) {
  const Settings settings = settings_with_encoder(1e-3);
  const TickCoefficients<2> coefficients = coefficients_of(settings);
  EXPECT_EQ(coefficients.encoder_step, 1e-3);
  TickState<2> state = state_at_start(Vector<2>(0.0));
  int in_contact = 0;
  for (int k = 1; k <= 2000; ++k) {
    const TickState<2> before = state;
    const Vector<2> goal(0.02 * std::sin(k * 0.01), 0.01 * std::cos(k * 0.007));
    tick(coefficients, goal, state);
    const Snapshot snapshot = snapshot_of(coefficients, state);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      const auto& [rendering, proxy_gain] = coefficients.strategies[i];
      const auto& was = before.strategies[i];
      const auto& is = state.strategies[i];
      const Vector<2> seen_before = measured_position(1e-3, was.motion.position);
      const Vector<2> held_force = rendering * (was.proxy - seen_before);
      const DeviceMotion<2> motion = step(coefficients.device, was.motion, goal, held_force);
      ASSERT_EQ(is.motion.position, motion.position);
      ASSERT_EQ(is.motion.velocity, motion.velocity);
      Vector<2> proxy(0.0);
      ASSERT_EQ(is.in_contact, place_proxy(seen_before, coefficients.wall, proxy_gain, proxy));
      ASSERT_EQ(is.proxy, proxy);
      const Vector<2> force = rendering * (proxy - measured_position(1e-3, motion.position));
      ASSERT_EQ(snapshot.strategies[i].force, force);
      ASSERT_EQ(snapshot.strategies[i].device, motion.position) << "exact, as a measurement from outside would be";
      in_contact += is.in_contact ? 1 : 0;
    }
  }
  EXPECT_GT(in_contact, 1000);
  EXPECT_LT(in_contact, 5000);
}

// A real device's encoder has counted already.
TEST(EncoderTest, AMeasuredDeviceIsNotRoundedAgain) {
  const TickCoefficients<2> coefficients = coefficients_of(settings_with_encoder(1e-3));
  const TickCoefficients<2> exact = coefficients_of(settings_with_encoder(0.0));
  TickState<2> state = state_at_start(Vector<2>(0.0));
  TickState<2> same = state;
  const std::size_t active = index_of(StrategyId::naive);
  for (int k = 1; k < 100; ++k) {
    const Vector<2> handle(0.01 + k * 1.3e-5, -0.01);
    tick_with_device(coefficients, StrategyId::naive, handle, Vector<2>(0.1), 200.0, state);
    tick_with_device(exact, StrategyId::naive, handle, Vector<2>(0.1), 200.0, same);
    const Snapshot snapshot = snapshot_of(coefficients, state);
    ASSERT_EQ(snapshot.strategies[active].proxy, snapshot_of(exact, same).strategies[active].proxy);
    ASSERT_EQ(snapshot.strategies[active].force, snapshot_of(exact, same).strategies[active].force);
  }
  const std::size_t simulated = index_of(StrategyId::anisotropic);
  EXPECT_NE(state.strategies[simulated].proxy, same.strategies[simulated].proxy) << "the others have one";
}

}  // namespace
}  // namespace ghostforce::encoder_test
