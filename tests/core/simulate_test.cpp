#include "core/simulate.h"

#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/random_setting.h"

namespace ghostforce::simulate_test {
namespace {

Scene example() {
  Scene scene;
  scene.settings.wall_normal_angle = 0.75 * std::numbers::pi;
  scene.settings.mass = 0.1;
  scene.settings.damping = 5.0;
  scene.settings.rate = 1000.0;
  scene.settings.stiffnesses = make_stiffnesses(100.0, 1000.0, 1000.0, 1e5);
  scene.goal = {{{-0.04, 0.04}, {0.04, -0.04}}, {0.0, 1.0}, Motion::minimum_jerk};
  scene.duration = 1.5;
  return scene;
}

TEST(SimulateTest, ReportsEveryTickFromTheFirstToTheLast) {
  const Scene scene = example();
  std::vector<Snapshot> ticks;
  const TickState<2> state = simulate(scene, last_tick(scene), [&](const Snapshot& s) { ticks.push_back(s); });
  ASSERT_EQ(ticks.size(), 1501U);
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    ASSERT_EQ(ticks[k].tick, static_cast<std::int64_t>(k));
    ASSERT_EQ(ticks[k].time_s, static_cast<double>(k) / 1000.0);
    ASSERT_EQ(ticks[k].goal, goal_at(scene.goal, ticks[k].time_s));
  }
  EXPECT_EQ(ticks[0].strategies[0].device, Vector<2>(-0.04, 0.04));
  EXPECT_EQ(ticks[0].strategies[0].force, Vector<2>(0.0));
  EXPECT_EQ(state.tick, 1500);
}

// The hand as its scene has it: at each tick as stiff as its path says, and as far from its way as its tremor and drift
// take it.
TEST(SimulateTest, TheHandChangesAndIsNotStill) {
  Scene scene = example();
  scene.stiffness_path = {{100.0, 900.0, 50.0}, {0.0, 0.5, 1.2}};
  scene.tremor_and_drift = {.tremor_rms = 0.0005, .drift_speed = 0.01, .seed = 3.0};
  scene.settings.encoder_step = 60e-6;
  const TremorAndDriftMotion tremor_and_drift(scene.tremor_and_drift);
  TickState<2> expected = state_at_start(scene.settings, scene.goal.points.front());
  std::int64_t at = 0;
  const TickState<2> end = simulate(scene, last_tick(scene), [&](const Snapshot& snapshot) {
    while (at < snapshot.tick) {
      const double time_s = time_of(++at, 1000.0);
      Settings now = scene.settings;
      now.stiffnesses.believed_k_u = 100.0;
      now.stiffnesses.k_u = stiffness_at(scene.stiffness_path, time_s);
      tick(coefficients_of(now), goal_at(scene.goal, time_s) + tremor_and_drift.at(time_s), expected);
    }
    ASSERT_EQ(snapshot.goal, expected.goal);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      ASSERT_EQ(snapshot.strategies[i].device, expected.strategies[i].motion.position) << snapshot.tick;
      ASSERT_EQ(snapshot.strategies[i].proxy, expected.strategies[i].proxy) << snapshot.tick;
    }
  });
  EXPECT_EQ(end.tick, 1500);
  EXPECT_NE(end.goal, scene.goal.points.back());
}

// The same ticks as any other: bit for bit what the servo would compute, and what it may go on from.
TEST(SimulateTest, IsTheTickRepeated) {
  const Scene scene = example();
  const TickCoefficients<2> coefficients = coefficients_of(scene.settings);
  TickState<2> expected = state_at_start(scene.goal.points.front());
  std::int64_t at = 0;
  const auto check = [&](const Snapshot& snapshot) {
    while (at < snapshot.tick) tick(coefficients, goal_at(scene.goal, time_of(++at, 1000.0)), expected);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      ASSERT_EQ(snapshot.strategies[i].device, expected.strategies[i].motion.position);
      ASSERT_EQ(snapshot.strategies[i].proxy, expected.strategies[i].proxy);
      ASSERT_EQ(snapshot.strategies[i].energy, expected.strategies[i].energy);
    }
  };
  const TickState<2> state = simulate(scene, 700, check);
  EXPECT_EQ(state.tick, 700);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    EXPECT_EQ(state.strategies[i].motion.velocity, expected.strategies[i].motion.velocity);
  }
}

// Nothing pushes in free space, from the first row on, also between two steps of the encoder.
TEST(SimulateTest, AnEncoderPushesNobodyInFreeSpace) {
  Scene scene = example();
  scene.settings.encoder_step = 0.002;
  scene.goal = {{Vector<2>(-0.0307, 0.0203)}, {0.0}, Motion::linear};
  const auto check = [](const Snapshot& snapshot) {
    for (const auto& strategy : snapshot.strategies) EXPECT_EQ(strategy.force, Vector<2>(0.0)) << snapshot.tick;
  };
  simulate(scene, 20, check);
  simulate_from(equilibrium_at_start(scene, scene.goal.points.front()), scene, 20, check);
}

TEST(SimulateTest, NoTicksIsTheStart) {
  int calls = 0;
  const TickState<2> state = simulate(example(), 0, [&](const Snapshot& s) {
    ++calls;
    EXPECT_EQ(s.tick, 0);
  });
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(state.tick, 0);
}

// Every strategy, in the wall and in free space, and with a wrong belief.
TEST(SimulateTest, NothingMovesFromRest) {
  Scene scene = example();
  scene.settings.stiffnesses.believed_k_u = 60.0;
  for (const Vector<2>& goal : {Vector<2>(0.04, -0.04), Vector<2>(0.0, -0.01), Vector<2>(-0.03, 0.02)}) {
    scene.goal = {{goal}, {0.0}, Motion::linear};
    const TickState<2> rest = equilibrium_state(scene.settings, goal);
    const bool is_inside = depth(wall_of(scene.settings), goal) > 0.0;
    EXPECT_EQ(rest.strategies[0].in_contact, is_inside);
    EXPECT_EQ(rest.strategies[0].motion.position == goal, !is_inside);
    const TickState<2> later = simulate_from(rest, scene, 500, [&](const Snapshot& snapshot) {
      for (std::size_t i = 0; i < strategy_count; ++i) {
        ASSERT_LT(glm::distance(snapshot.strategies[i].device, rest.strategies[i].motion.position), 1e-12);
        ASSERT_LT(glm::distance(snapshot.strategies[i].proxy, rest.strategies[i].proxy), 1e-12);
      }
    });
    EXPECT_EQ(later.tick, 500);
  }
}

}  // namespace
}  // namespace ghostforce::simulate_test
