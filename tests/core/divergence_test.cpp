#include "core/divergence.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/settings.h"
#include "tests/core/random_setting.h"

namespace ghostforce::divergence_test {
namespace {

TEST(DivergenceTest, OneBadNumberAnywhereIsEnough) {
  const TickState<2> good = state_at_start(Vector<2>{0.1, -0.2});
  ASSERT_FALSE(has_diverged(good));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    for (std::size_t i = 0; i < strategy_count; ++i) {
      const std::vector<std::function<double&(TickState<2>&)>> places{
          [](TickState<2>& s) -> double& { return s.goal.x; },
          [](TickState<2>& s) -> double& { return s.goal.y; },
          [i](TickState<2>& s) -> double& { return s.strategies[i].motion.position.x; },
          [i](TickState<2>& s) -> double& { return s.strategies[i].motion.position.y; },
          [i](TickState<2>& s) -> double& { return s.strategies[i].motion.velocity.x; },
          [i](TickState<2>& s) -> double& { return s.strategies[i].motion.velocity.y; },
          [i](TickState<2>& s) -> double& { return s.strategies[i].proxy.x; },
          [i](TickState<2>& s) -> double& { return s.strategies[i].proxy.y; },
          [i](TickState<2>& s) -> double& { return s.strategies[i].energy; },
      };
      for (std::size_t place = 0; place < places.size(); ++place) {
        TickState<2> state = good;
        places[place](state) = bad;
        EXPECT_TRUE(has_diverged(state)) << bad << " at " << place << " of " << i;
      }
    }
  }
}

TEST(DivergenceTest, TooFarAndTooLateHaveDiverged) {
  TickState<2> state = state_at_start(Vector<2>{0.0, 0.0});
  state.strategies[1].motion.position = {farthest_device_m, -farthest_device_m};
  EXPECT_FALSE(has_diverged(state));
  state.strategies[1].motion.position.y *= 1.001;
  EXPECT_TRUE(has_diverged(state));
  state = state_at_start(Vector<2>{0.0, 0.0});
  state.tick = -1;
  EXPECT_TRUE(has_diverged(state));
  state.tick = std::numeric_limits<std::int64_t>::max();
  EXPECT_TRUE(has_diverged(state));
}

// A stiffness that the rate cannot carry runs away; that is seen long before a number overflows.
TEST(DivergenceTest, UnstableSettingsAreSeenBeforeTheyOverflow) {
  Settings settings;
  settings.wall_normal_angle = 1.0;
  settings.mass = 0.1;
  settings.damping = 5.0;
  settings.rate = 100.0;
  settings.stiffnesses = make_stiffnesses(100.0, 1e5, 1e5, 1e5);
  const TickCoefficients<2> coefficients = coefficients_of(settings);
  TickState<2> state = state_at_start(Vector<2>{-0.02, -0.02});
  int ticks = 0;
  while (!has_diverged(state) && ticks < 10000) {
    tick(coefficients, Vector<2>{-0.02, -0.02}, state);
    ++ticks;
  }
  EXPECT_LT(ticks, 1000);
  for (const auto& strategy : state.strategies) EXPECT_TRUE(std::isfinite(strategy.motion.position.x));
}

static_assert(noexcept(has_diverged(std::declval<const TickState<2>&>())));

}  // namespace
}  // namespace ghostforce::divergence_test
