// Whatever is asked of the motors, what they get is a number, under the limit, and changes no faster than allowed.
#include "core/force_limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/support/long_run.h"

namespace ghostforce::force_limiter_test {
namespace {

constexpr double dt = 0.001;

// Rounding of sums of numbers of this size, many times over.
constexpr double rounding = 1e-12;

Vector<2> settle(ForceLimiter& limiter, const Vector<2>& wanted, double gain = 1.0, double limit = 6.0) {
  for (int i = 0; i < 1000; ++i) limiter.pass(wanted, gain, limit, dt);
  return limiter.sent();
}

TEST(ForceLimiter, LetsThroughWhatIsAllowed) {
  ForceLimiter limiter;
  EXPECT_EQ(settle(limiter, {1.0, -2.0}), (Vector<2>{1.0, -2.0}));
  EXPECT_FALSE(limiter.pass({1.0, -2.0}, 1.0, 6.0, dt).was_saturated);
}

TEST(ForceLimiter, ShortensTheVectorAndKeepsItsDirection) {
  ForceLimiter limiter;
  const Vector<2> sent = settle(limiter, {30.0, -40.0});
  EXPECT_NEAR(glm::length(sent), 6.0, rounding);
  EXPECT_NEAR(sent.x / sent.y, 30.0 / -40.0, rounding);
  EXPECT_TRUE(limiter.pass({30.0, -40.0}, 1.0, 6.0, dt).was_saturated);
}

TEST(ForceLimiter, NobodyGetsMoreThanTheCeiling) {
  ForceLimiter limiter;
  EXPECT_NEAR(glm::length(settle(limiter, {1e9, 0.0}, 1.0, 1e9)), force_ceiling, rounding);
}

TEST(ForceLimiter, GrowsNoFasterThanAllowed) {
  ForceLimiter limiter;
  EXPECT_NEAR(glm::length(limiter.pass({6.0, 0.0}, 1.0, 6.0, dt).force), ForceLimiter::slew * dt, rounding);
  EXPECT_NEAR(glm::length(limiter.pass({6.0, 0.0}, 1.0, 6.0, dt).force), 2.0 * ForceLimiter::slew * dt, rounding);
}

TEST(ForceLimiter, ALateTickEarnsNoLeap) {
  ForceLimiter limiter;
  EXPECT_NEAR(glm::length(limiter.pass({6.0, 0.0}, 1.0, 6.0, 10.0).force),
              ForceLimiter::slew * ForceLimiter::longest_step_s, rounding);
}

TEST(ForceLimiter, LeadsOverFromOneLawToAnother) {
  ForceLimiter limiter;
  settle(limiter, {4.0, 0.0});
  limiter.cross_fade();
  double before = 4.0;
  for (double t = dt; t < ForceLimiter::cross_fade_s; t += dt) {
    const Vector<2> force = limiter.pass({-4.0, 0.0}, 1.0, 6.0, dt).force;
    // A straight line in time, from the first tick to the last.
    EXPECT_NEAR(force.x, 4.0 - 8.0 * t / ForceLimiter::cross_fade_s, 1e-9);
    EXPECT_LT(force.x, before);
    before = force.x;
  }
  EXPECT_NEAR(settle(limiter, {-4.0, 0.0}).x, -4.0, rounding);
}

TEST(ForceLimiter, ASecondChangeBeginsWhereTheFirstHasCome) {
  ForceLimiter limiter;
  settle(limiter, {4.0, 0.0});
  limiter.cross_fade();
  for (int i = 0; i < 75; ++i) limiter.pass({-4.0, 0.0}, 1.0, 6.0, dt);
  const Vector<2> half_way = limiter.sent();
  limiter.cross_fade();
  const Vector<2> next = limiter.pass({4.0, 0.0}, 1.0, 6.0, dt).force;
  EXPECT_NEAR(half_way.x, 0.0, 1e-9);
  EXPECT_NEAR(next.x, 4.0 * dt / ForceLimiter::cross_fade_s, 1e-9);
}

// A probe has its own envelope, and a law that wants more than the limit does not hide it.
TEST(ForceLimiter, AddsAProbeToWhatTheGainAndTheLimitHaveLeft) {
  ForceLimiter limiter;
  const auto settle_with = [&](const Vector<2>& wanted, double gain, const Vector<2>& probe) {
    for (int i = 0; i < 1000; ++i) limiter.pass(wanted, gain, 6.0, dt, Vector<2>(0.0), probe);
    return limiter.sent();
  };
  EXPECT_EQ(settle_with({0.0, 0.0}, 0.0, {0.5, -0.25}), (Vector<2>{0.5, -0.25}));
  EXPECT_EQ(settle_with({30.0, 0.0}, 1.0, {-2.0, 0.0}), (Vector<2>{4.0, 0.0}));
  EXPECT_NEAR(glm::length(settle_with({30.0, 0.0}, 1.0, {2.0, 1.0})), 6.0, rounding);
  EXPECT_LT(glm::length(limiter.pass({0.0, 0.0}, 1.0, 6.0, dt, Vector<2>(0.0), {-1e300, 1e300}).force), 6.0);
}

TEST(ForceLimiter, NothingThatIsNoNumberPasses) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Vector<2> wanted : {Vector<2>{nan, 0.0}, Vector<2>{0.0, infinity}, Vector<2>{-infinity, nan}}) {
    ForceLimiter limiter;
    settle(limiter, {3.0, 0.0});
    const ForceLimiter::Result result = limiter.pass(wanted, 1.0, 6.0, dt);
    EXPECT_FALSE(result.was_finite);
    EXPECT_EQ(result.force, Vector<2>(0.0));
    EXPECT_EQ(settle(limiter, {0.1, 0.0}).x, 0.1);  // and it goes on
  }
  ForceLimiter limiter;
  settle(limiter, {3.0, 0.0});
  EXPECT_EQ(limiter.pass({3.0, 0.0}, nan, 6.0, dt).force, Vector<2>(0.0));
  EXPECT_EQ(settle(limiter, {3.0, 0.0}, 1.0, nan), Vector<2>(0.0));
}

// Ten million ticks of whatever can go wrong: jumps, numbers that are none, times that stand still or leap, limits and
// laws that change at any moment. The one promise: a finite force, under the limit that was asked for or on its way
// down to it, and no faster than allowed.
TEST(ForceLimiter, KeepsItsPromiseUnderMillionsOfHostileTicks) {
  std::mt19937_64 random{20200417};
  const auto any = [&](double least, double greatest) {
    return std::uniform_real_distribution<double>(least, greatest)(random);
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  ForceLimiter limiter;
  Vector<2> wanted{0.0};
  Vector<2> probe{0.0};
  double gain = 1.0;
  double limit = 6.0;
  double allowed = 6.0;  // the limit, as fast as it may come down
  std::int64_t moved = 0;
  const int ticks = is_long_run() ? 10'000'000 : 1'000'000;
  for (int i = 0; i < ticks; ++i) {
    double elapsed = 0.001;
    const std::uint64_t dice = random() % 256;
    if (dice < 16) wanted = {any(-1e3, 1e3), any(-1e3, 1e3)};
    if (dice >= 16 && dice < 180) wanted += Vector<2>{any(-0.1, 0.1), any(-0.1, 0.1)};
    if (dice == 180) wanted = {1e300, -1e300};
    if (dice == 181) wanted = {nan, 1.0};
    if (dice == 182) wanted = {infinity, -1.0};
    if (dice == 183) wanted = Vector<2>(0.0);
    if (dice == 184) gain = any(0.0, 1.0);
    if (dice == 185) gain = any(-10.0, 10.0);
    if (dice == 186) gain = nan;
    if (dice == 187) gain = 1.0;
    if (dice == 188) limit = any(0.0, 10.0);
    if (dice == 189) limit = any(-1.0, 1e6);
    if (dice == 190) limit = nan;
    if (dice == 191) limit = 6.0;
    if (dice == 192) limiter.cross_fade();
    if (dice == 193) elapsed = 0.0;
    if (dice == 194) elapsed = any(-1.0, 10.0);
    if (dice == 195) elapsed = nan;
    if (dice == 196) elapsed = infinity;
    if (dice >= 198 && dice < 210) probe = {any(-3.0, 3.0), any(-3.0, 3.0)};
    if (dice == 210) probe = {-1e300, 1e300};
    if (dice == 211) probe = {0.0, nan};
    if (dice >= 212 && dice < 216) probe = Vector<2>(0.0);
    if (dice == 197 && i % 16 == 0) {
      limiter.reset();
      allowed = 0.0;
    }

    const Vector<2> before = limiter.sent();
    const ForceLimiter::Result result = limiter.pass(wanted, gain, limit, elapsed, Vector<2>(0.0), probe);
    const double step = elapsed > 0.0 ? std::min(elapsed, ForceLimiter::longest_step_s) : 0.0;
    const double change = ForceLimiter::slew * step;
    const double wanted_limit = limit > 0.0 ? std::min(limit, force_ceiling) : 0.0;
    allowed = std::max(wanted_limit, allowed - 0.5 * change);
    ASSERT_TRUE(std::isfinite(result.force.x) && std::isfinite(result.force.y)) << i;
    ASSERT_LE(glm::length(result.force), std::min(allowed, force_ceiling) + rounding) << i;
    if (!result.was_finite) {
      ASSERT_EQ(result.force, Vector<2>(0.0)) << i;
      allowed = wanted_limit;
    } else {
      ASSERT_LE(glm::length(result.force - before), change + rounding) << i;
    }
    if (result.force != before) ++moved;
  }
  EXPECT_GT(moved, ticks / 10);  // it was about something
}

}  // namespace
}  // namespace ghostforce::force_limiter_test
