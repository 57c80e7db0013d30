// A tick in a running servo: its time, settings that change while it runs, and what its thread may rely on.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "core/settings.h"
#include "core/tick.h"
#include "tests/core/random_setting.h"

namespace ghostforce::tick_live_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Tick, TimeIsNeverAccumulated) {
  EXPECT_EQ(time_of(0, 1000.0), 0.0);
  EXPECT_EQ(time_of(3, 1000.0), 0.003);
  EXPECT_EQ(time_of(1'234'567, 1000.0), 1234.567);
  EXPECT_EQ(time_of(86'400'000, 1000.0), 86400.0);
  EXPECT_EQ(time_of(7, 10.0), 0.7);
  Settings settings;
  settings.mass = 0.1;
  settings.rate = 1000.0;
  settings.stiffnesses = make_stiffnesses(100.0, 100.0, 100.0, 1e5);
  const TickCoefficients<2> coefficients = coefficients_of(settings);
  TickState<2> state = state_at_start(Vector<2>(0.0));
  for (int k = 0; k < 12345; ++k) tick(coefficients, Vector<2>(0.0), state);
  EXPECT_EQ(snapshot_of(coefficients, state).time_s, 12.345);
}

// Every setting pulled about while the loop runs, soft to hard, motor turned, wall turned, rendering off: whatever
// comes out is a number, and stays within reach of the goals.
TEST(Tick, SettingsChangedLiveStayFinite) {
  Random random(7);
  Settings settings;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses = make_stiffnesses(100.0, 600.0, 600.0, 1e5);
  TickState<2> state = state_at_start(Vector<2>(0.0));
  for (int change = 0; change < 2000; ++change) {
    SCOPED_TRACE(change);
    // Ranges in which the loop is stable at 1 kHz with b = 5 N·s/m: k_r dt up to 1, a fifth of it.
    switch (random.below(10)) {
      case 0:
        settings.wall_normal_angle = random.uniform(-10.0, 10.0);
        break;
      case 1:
        settings.actuated_angle = random.uniform(-10.0, 10.0);
        break;
      case 2:
        settings.wall_point = random.in_box<2>(0.05);
        break;
      case 3:
        settings.stiffnesses.k_r = random.once_in(4) ? 0.0 : random.over_decades(1.0, 1000.0);
        break;
      case 4:
        settings.stiffnesses.k_t = random.over_decades(0.1, 1e6);
        break;
      case 5:
        settings.stiffnesses.k_c = random.once_in(3) ? infinity : random.over_decades(1.0, 1e9);
        break;
      case 6:
        settings.stiffnesses.k_u = random.over_decades(10.0, 1000.0);
        break;
      case 7:
        settings.stiffnesses.believed_k_u = random.over_decades(10.0, 1000.0);
        break;
      case 8:
        settings.stiffnesses.chosen_tracking_ratio =
            random.once_in(2) ? std::optional<double>{} : random.over_decades(0.1, 30.0);
        break;
      default:
        settings.mass = random.over_decades(0.05, 1.0);
        break;
    }
    const TickCoefficients<2> coefficients = coefficients_of(settings);
    for (int k = 0; k < 20; ++k) {
      tick(coefficients, random.in_box<2>(0.05), state);
      const Snapshot snapshot = snapshot_of(coefficients, state);
      for (const auto& strategy : snapshot.strategies) {
        for (const Vector<2>& v : {strategy.device, strategy.proxy, strategy.contact, strategy.force,
                                   strategy.ghost_force, strategy.proxy_drift}) {
          ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y));
        }
        ASSERT_TRUE(std::isfinite(strategy.energy));
        ASSERT_LE(glm::length(strategy.device), 1.0);
      }
    }
  }
}

// Each strategy is simulated by itself: what one does leaves the others alone. Changing ρ changes the anisotropic only.
TEST(Tick, StrategiesRunBesideEachOther) {
  Settings settings;
  settings.wall_normal_angle = 0.75 * std::numbers::pi;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses = make_stiffnesses(100.0, 600.0, 600.0, 1e5);
  const TickCoefficients<2> coefficients = coefficients_of(settings);
  settings.stiffnesses.chosen_tracking_ratio = 2.0;
  const TickCoefficients<2> other_coefficients = coefficients_of(settings);
  TickState<2> state = state_at_start(Vector<2>{0.02, -0.02});
  TickState<2> other = state;
  for (int k = 0; k < 500; ++k) {
    tick(coefficients, Vector<2>{0.02, -0.02}, state);
    tick(other_coefficients, Vector<2>{0.02, -0.02}, other);
  }
  for (const StrategyId id : {StrategyId::full, StrategyId::naive}) {
    EXPECT_EQ(state.strategies[index_of(id)].motion.position, other.strategies[index_of(id)].motion.position);
  }
  EXPECT_GT(glm::length(state.strategies[index_of(StrategyId::anisotropic)].motion.position -
                        other.strategies[index_of(StrategyId::anisotropic)].motion.position),
            1e-4);
}

// The example of docs/theory.md, played: the naïve device ends on the other side of where it went in, x = 0.
TEST(TickExample, NaiveEndsOnTheOtherSide) {
  Settings settings;
  settings.wall_normal_angle = 0.75 * std::numbers::pi;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 1000.0;
  settings.stiffnesses = make_stiffnesses(100.0, 1000.0, 1000.0, 1e5);
  const TickCoefficients<2> coefficients = coefficients_of(settings);
  TickState<2> state = state_at_start(Vector<2>{-0.04, 0.04});
  for (int k = 1; k <= 3000; ++k) {
    const double share = std::min(k / 1000.0, 1.0);
    tick(coefficients, Vector<2>{-0.04 + 0.08 * share, 0.04 - 0.08 * share}, state);
  }
  const Snapshot snapshot = snapshot_of(coefficients, state);
  // Two seconds after the last motion the slowest mode, 50 ms, is gone; three decimals are asked for.
  EXPECT_NEAR(snapshot.strategies[index_of(StrategyId::full)].device.x, 3.669e-3, 0.5e-6);
  EXPECT_NEAR(snapshot.strategies[index_of(StrategyId::naive)].device.x, -26.556e-3, 0.5e-6);
  EXPECT_NEAR(snapshot.strategies[index_of(StrategyId::anisotropic)].device.x, 3.669e-3, 0.5e-6);
  EXPECT_NEAR(snapshot.strategies[index_of(StrategyId::full)].force.x, -3.633, 0.5e-3);
  EXPECT_NEAR(snapshot.strategies[index_of(StrategyId::naive)].force.x, -6.656, 0.5e-3);
  EXPECT_NEAR(snapshot.strategies[index_of(StrategyId::anisotropic)].force.x, -3.633, 0.5e-3);
  EXPECT_NEAR(snapshot.strategies[index_of(StrategyId::naive)].ghost_force.x, -3.023, 1e-3);
}

// The servo's promises, checked by the compiler.
static_assert(noexcept(tick(std::declval<const TickCoefficients<2>&>(), std::declval<const Vector<2>&>(),
                            std::declval<TickState<2>&>())));
static_assert(noexcept(snapshot_of(std::declval<const TickCoefficients<2>&>(), std::declval<const TickState<2>&>())));
static_assert(noexcept(coefficients_of(std::declval<const Wall<2>&>(), std::declval<const Actuation<2>&>(),
                                       std::declval<const Stiffnesses&>(), 1.0, 1.0, 1.0)));
static_assert(noexcept(state_at_start(std::declval<const Vector<2>&>())));
static_assert(noexcept(time_of(1, 1.0)));
template <glm::length_t D>
constexpr bool crosses_threads_whole = std::is_trivially_copyable_v<TickCoefficients<D>>&&
    std::is_trivially_copyable_v<TickState<D>>&& std::is_trivially_copyable_v<SnapshotIn<D>>;
static_assert(crosses_threads_whole<2> && crosses_threads_whole<3> && crosses_threads_whole<4>);

}  // namespace
}  // namespace ghostforce::tick_live_test
