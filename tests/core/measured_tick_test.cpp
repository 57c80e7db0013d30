// A tick with a real device: what is measured, what is inferred from it, and what goes on being simulated.
#include "core/tick.h"

#include <gtest/gtest.h>

#include <glm/trigonometric.hpp>

#include "core/equilibrium.h"
#include "core/settings.h"

namespace ghostforce::measured_tick_test {
namespace {

Settings figure_settings() {
  Settings settings;
  settings.wall_normal_angle = glm::radians(135.0);
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses.k_u = 100.0;
  settings.stiffnesses.k_r = 1000.0;
  settings.stiffnesses.k_t = 1000.0;
  settings.stiffnesses.k_c = 1e5;
  return settings;
}

TEST(MeasuredTick, FreeSpaceIsExactlyForceFree) {
  const TickCoefficients<2> coefficients = coefficients_of(figure_settings());
  TickState<2> state = state_at_start(Vector<2>(-0.05, 0.05));
  for (int i = 1; i <= 10; ++i) {
    const Vector<2> handle(-0.05 + 0.001 * i, 0.05);  // it moves, and still
    tick_with_device(coefficients, StrategyId::naive, handle, Vector<2>(0.0), 100.0, state);
    const Snapshot snapshot = snapshot_of(coefficients, state);
    const auto& naive = snapshot.strategies[index_of(StrategyId::naive)];
    EXPECT_EQ(naive.force, Vector<2>(0.0));
    EXPECT_EQ(naive.device, handle);
    EXPECT_EQ(naive.proxy, handle);
    EXPECT_FALSE(naive.in_contact);
    EXPECT_EQ(snapshot.goal, handle);
    EXPECT_EQ(snapshot.measured, StrategyId::naive);
    EXPECT_EQ(snapshot.tick, i);
  }
}

// The handle held where a strategy comes to rest under a goal: the force is that of the closed form in the same tick,
// and the goal that is inferred from it is the one that led there.
TEST(MeasuredTick, InfersTheGoalFromWhereTheHandleRests) {
  const Settings settings = figure_settings();
  const TickCoefficients<2> coefficients = coefficients_of(settings);
  const Vector<2> goal(0.04, -0.04);
  for (const Strategy& entry : strategy_catalog()) {
    const Equilibrium<2> rest = equilibrium_of(entry.id, settings, goal);
    TickState<2> state = state_at_start(Vector<2>(-0.05, 0.05));
    tick_with_device(coefficients, entry.id, rest.device, rest.force, settings.stiffnesses.k_u, state);
    const Snapshot snapshot = snapshot_of(coefficients, state);
    const auto& measured = snapshot.strategies[index_of(entry.id)];
    // Sums of numbers of some centimetres and newtons, in doubles.
    EXPECT_NEAR(glm::length(measured.force - rest.force), 0.0, 1e-12) << entry.name;
    EXPECT_NEAR(glm::length(measured.proxy - rest.proxy), 0.0, 1e-14) << entry.name;
    EXPECT_NEAR(glm::length(snapshot.goal - goal), 0.0, 1e-14) << entry.name;
    EXPECT_TRUE(measured.in_contact);
  }
}

TEST(MeasuredTick, AWrongBeliefMisplacesTheGoal) {
  const Settings settings = figure_settings();
  const TickCoefficients<2> coefficients = coefficients_of(settings);
  const Equilibrium<2> rest = equilibrium_of(StrategyId::full, settings, Vector<2>(0.04, -0.04));
  TickState<2> state = state_at_start(rest.device);
  tick_with_device(coefficients, StrategyId::full, rest.device, rest.force, 50.0, state);
  EXPECT_NEAR(glm::length(state.goal - (rest.device - rest.force / 50.0)), 0.0, 1e-14);
}

TEST(MeasuredTick, TheOthersAreSimulatedUnderTheInferredGoal) {
  const Settings settings = figure_settings();
  const TickCoefficients<2> coefficients = coefficients_of(settings);
  const Vector<2> goal(0.04, -0.04);
  const Equilibrium<2> rest = equilibrium_of(StrategyId::naive, settings, goal);
  TickState<2> state = state_at_start(rest.device);
  for (int i = 0; i < 3000; ++i)
    tick_with_device(coefficients, StrategyId::naive, rest.device, rest.force, 100.0, state);
  for (const StrategyId other : {StrategyId::full, StrategyId::anisotropic}) {
    // After 3 s nothing moves any more: the slowest motion of these settings halves every 35 ms.
    EXPECT_NEAR(
        glm::length(state.strategies[index_of(other)].motion.position - equilibrium_of(other, settings, goal).device),
        0.0, 1e-9);
  }
}

TEST(MeasuredTick, CountsTheWorkDoneOnTheRealHand) {
  const TickCoefficients<2> coefficients = coefficients_of(figure_settings());
  TickState<2> state = state_at_start(Vector<2>(0.02, -0.02));
  tick_with_device(coefficients, StrategyId::full, Vector<2>(0.02, -0.02), Vector<2>(0.0), 100.0, state);
  const Vector<2> force = snapshot_of(coefficients, state).strategies[index_of(StrategyId::full)].force;
  ASSERT_GT(glm::length(force), 1.0);
  const double before = state.strategies[index_of(StrategyId::full)].energy;
  tick_with_device(coefficients, StrategyId::full, Vector<2>(0.02, -0.01), Vector<2>(0.0), 100.0, state);
  EXPECT_DOUBLE_EQ(state.strategies[index_of(StrategyId::full)].energy - before, force.y * 0.01);
}

// Arming, another strategy or a gap in the measurements: the device has not gone from where a simulation had it to
// where it is, and certainly not in one tick.
TEST(MeasuredTick, ALeapFromSimulationToTheRealHandIsNoWork) {
  const TickCoefficients<2> coefficients = coefficients_of(figure_settings());
  TickState<2> state = state_at_start(Vector<2>(0.03, -0.03));
  for (int i = 0; i < 50; ++i) tick(coefficients, Vector<2>(0.03, -0.03), state);
  for (const StrategyId active : {StrategyId::naive, StrategyId::full, StrategyId::anisotropic, StrategyId::naive}) {
    const auto& own = state.strategies[index_of(active)];
    const double before = own.energy;
    ASSERT_GT(glm::length(snapshot_of(coefficients, state).strategies[index_of(active)].force), 0.05)
        << "a leap would count";
    tick_with_device(coefficients, active, Vector<2>(0.01, -0.02), Vector<2>(0.0), 100.0, state);
    EXPECT_EQ(own.energy, before);
    EXPECT_EQ(own.motion.velocity, Vector<2>(0.0));
    tick_with_device(coefficients, active, Vector<2>(0.011, -0.02), Vector<2>(0.0), 100.0, state);
    EXPECT_NE(own.energy, before) << "and from here on it counts";
    EXPECT_NEAR(own.motion.velocity.x, 1.0, 1e-9);  // 1 mm in 1 ms
  }
  const double before = state.strategies[index_of(StrategyId::naive)].energy;
  state.measured.reset();
  tick_with_device(coefficients, StrategyId::naive, Vector<2>(-0.01, -0.03), Vector<2>(0.0), 100.0, state);
  EXPECT_EQ(state.strategies[index_of(StrategyId::naive)].energy, before);
}

TEST(MeasuredTick, SimulationGoesOnFromWhereTheHandleWas) {
  const TickCoefficients<2> coefficients = coefficients_of(figure_settings());
  TickState<2> state = state_at_start(Vector<2>(-0.05, 0.05));
  for (int i = 0; i < 100; ++i)
    tick_with_device(coefficients, StrategyId::naive, Vector<2>(-0.03, 0.04), Vector<2>(0.0), 100.0, state);
  tick(coefficients, Vector<2>(-0.03, 0.04), state);
  EXPECT_FALSE(state.measured);
  EXPECT_NEAR(glm::length(state.strategies[index_of(StrategyId::naive)].motion.position - Vector<2>(-0.03, 0.04)), 0.0,
              1e-15);
}

}  // namespace
}  // namespace ghostforce::measured_tick_test
