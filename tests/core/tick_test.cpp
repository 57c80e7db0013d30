#include "core/tick.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/equilibrium.h"
#include "tests/core/dimensions.h"
#include "tests/core/random_setting.h"
#include "tests/core/reference_model.h"

namespace ghostforce::tick_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// What moves: a setting, the mass and damping of device and hand, and the rate of the loop.
template <glm::length_t D>
struct Loop {
  Setting<D> setting;
  double mass;
  double damping;
  double rate;

  TickCoefficients<D> coefficients() const {
    return coefficients_of(setting.wall, setting.actuation(), setting.stiffnesses, mass, damping, rate);
  }
};

// One reference loop per strategy, in the order of the catalog.
template <glm::length_t D>
PerStrategy<ReferenceLoop> reference_loops(const Loop<D>& loop) {
  const Stiffnesses& k = loop.setting.stiffnesses;
  const Extended belief = k.believed_k_u.value_or(k.k_u);
  const Extended ratio = k.chosen_tracking_ratio ? Extended{*k.chosen_tracking_ratio} : 1.0L + k.k_r / belief;
  const Extended period = 1.0L / loop.rate;
  return {ReferenceLoop{fully_actuated_reference(loop.setting), loop.mass, loop.damping, period},
          ReferenceLoop{underactuated_reference(loop.setting, 1.0L), loop.mass, loop.damping, period},
          ReferenceLoop{underactuated_reference(loop.setting, ratio), loop.mass, loop.damping, period}};
}

template <glm::length_t D>
double slowest_mode(const Loop<D>& loop) {
  double slowest = 0.0;
  for (const ReferenceLoop& one : reference_loops(loop)) slowest = std::max(slowest, reference_slowest_mode(one));
  return slowest;
}

// Loops that settle. A sampled wall is stable where the damping outweighs what the delay of about 1.5 periods gives
// back to the hand, b > 1.5 k_r dt less the k_r dt that the held force takes; a hand and rendering with a natural
// period of 30 to 60 ticks, critically damped (b = 2 √(m (k_u + k_r)) = 2 (k_u + k_r)/ω), have b of 10 (k_u + k_r) dt
// or more. The slow mode is then b/k_u long, which the range of k_r/k_u keeps below some thousand ticks. slowest_mode()
// checks it all.
template <glm::length_t D>
Loop<D> random_stable_loop(Random& random) {
  while (true) {
    Loop<D> loop{random_setting<D>(random), 0.0, 0.0, random.over_decades(100.0, 10000.0)};
    Stiffnesses& k = loop.setting.stiffnesses;
    k.k_r = k.k_u * random.over_decades(0.1, 10.0);
    if (random.once_in(3)) k.believed_k_u = k.k_u * random.over_decades(0.3, 3.0);
    if (random.once_in(5)) k.chosen_tracking_ratio = random.over_decades(0.1, 30.0);
    const double omega = 2.0 * std::numbers::pi * loop.rate / random.uniform(30.0, 60.0);
    loop.mass = (k.k_u + k.k_r) / (omega * omega);
    loop.damping = 2.0 * (k.k_u + k.k_r) / omega;
    if (slowest_mode(loop) < 0.998) return loop;
  }
}

// Ticks after which the slowest mode has shrunk by 1e-13.
template <glm::length_t D>
std::int64_t ticks_to_rest(const Loop<D>& loop) {
  return 100 + static_cast<std::int64_t>(std::log(1e-13) / std::log(slowest_mode(loop)));
}

// Sum of the lengths that the roundings of a loop are measured by [m].
template <glm::length_t D>
double extent(const Loop<D>& loop) {
  return glm::length(loop.setting.wall.point) + glm::length(loop.setting.goal);
}

template <typename Dimension>
class TickTest : public testing::Test {};
TYPED_TEST_SUITE(TickTest, Dimensions, DimensionName);

// --- At rest ---------------------------------------------------------------------------------------------------------

// The loop knows nothing of equilibria; held long enough under one goal it must find that of (6)(7) by itself.
TYPED_TEST(TickTest, ComesToRestAtTheEquilibrium) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const Loop<D> loop = random_stable_loop<D>(random);
    const Setting<D>& setting = loop.setting;
    const TickCoefficients<D> coefficients = loop.coefficients();
    // From the free side, so that the wall is met with speed.
    TickState<D> state = state_at_start(setting.wall.point + 0.02 * setting.wall.normal);
    for (std::int64_t k = ticks_to_rest(loop); k > 0; --k) tick(coefficients, setting.goal, state);
    const SnapshotIn<D> snapshot = snapshot_of(coefficients, state);

    // What is left of the slowest mode is 1e-13 of the way; each tick's rounding, an ε of the extent, is remembered for
    // 1/(1 − 0.998) = 500 ticks; both are multiplied by the gain from depth to proxy, below 30 for these ratios. Hence
    // 1e-10 of the extent, and k_r times that for the force.
    const double tolerance = 1e-10 * extent(loop);
    const PerStrategy<ReferenceLoop> loops = reference_loops(loop);
    for (const Strategy& entry : strategy_catalog()) {
      SCOPED_TRACE(entry.name);
      const auto& rest = snapshot.strategies[index_of(entry.id)];
      const auto balance = reference_equilibrium(loops[index_of(entry.id)].model, reference(setting.goal));
      EXPECT_LE(distance(rest.device, balance.device), tolerance);
      EXPECT_LE(distance(rest.proxy, balance.proxy), tolerance);
      EXPECT_LE(distance(rest.force, balance.force), tolerance * setting.stiffnesses.k_r);
      EXPECT_TRUE(rest.in_contact);
      const auto closed = equilibrium_of(entry, setting.wall, setting.actuation(), setting.stiffnesses, setting.goal);
      EXPECT_LE(glm::length(rest.device - closed.device), tolerance);
      EXPECT_LE(glm::length(rest.proxy - closed.proxy), tolerance);
      EXPECT_LE(glm::length(rest.contact - closed.contact), tolerance);
      EXPECT_LE(glm::length(rest.force - closed.force), tolerance * setting.stiffnesses.k_r);
    }
  }
}

// With the right belief and the optimal ratio the cure's ghost force and drift die away; the naïve ones stay.
TYPED_TEST(TickTest, CureEndsGhostForceAndDrift) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(2);
  int tried = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    Loop<D> loop = random_stable_loop<D>(random);
    Setting<D>& setting = loop.setting;
    setting.stiffnesses.believed_k_u.reset();
    setting.stiffnesses.chosen_tracking_ratio.reset();
    const double alpha = glm::dot(setting.wall.normal, setting.actuation().actuated * setting.wall.normal);
    if (alpha < 0.1 || alpha > 0.9 || depth(setting.wall, setting.goal) < 0.01 || slowest_mode(loop) > 0.998) continue;
    ++tried;
    const TickCoefficients<D> coefficients = loop.coefficients();
    TickState<D> state = state_at_start(setting.goal);
    for (std::int64_t k = ticks_to_rest(loop); k > 0; --k) tick(coefficients, setting.goal, state);
    const SnapshotIn<D> snapshot = snapshot_of(coefficients, state);
    const double tolerance = 1e-10 * extent(loop);  // as above
    const auto& anisotropic = snapshot.strategies[index_of(StrategyId::anisotropic)];
    EXPECT_LE(glm::length(anisotropic.ghost_force), tolerance * setting.stiffnesses.k_r);
    EXPECT_LE(glm::length(anisotropic.proxy_drift), tolerance);
    const auto& naive = snapshot.strategies[index_of(StrategyId::naive)];
    EXPECT_GT(glm::length(naive.ghost_force), 1e4 * tolerance * setting.stiffnesses.k_r);
    EXPECT_GT(glm::length(naive.proxy_drift), 1e4 * tolerance);
    const auto& full = snapshot.strategies[index_of(StrategyId::full)];
    EXPECT_EQ(full.ghost_force, Vector<D>(0.0));
    EXPECT_LE(glm::length(full.proxy_drift), tolerance);
  }
  EXPECT_GT(tried, 100);
}

// --- Tick by tick ----------------------------------------------------------------------------------------------------

// A hand that goes back and forth through the wall: waypoints either side of it, smoothly joined.
template <glm::length_t D>
std::vector<Vector<D>> script(const Loop<D>& loop, Random& random, int stretches, int ticks_per_stretch) {
  const Wall<D>& wall = loop.setting.wall;
  std::vector<Vector<D>> goals;
  Vector<D> from = wall.point + along(wall, random.in_box<D>(0.05)) + 0.01 * wall.normal;
  for (int i = 0; i < stretches; ++i) {
    const double height = i % 2 == 0 ? random.uniform(-0.05, 0.0) : random.uniform(-0.01, 0.03);
    const Vector<D> to = wall.point + along(wall, random.in_box<D>(0.05)) + height * wall.normal;
    for (int j = 0; j < ticks_per_stretch; ++j) goals.push_back(from + (j / double(ticks_per_stretch)) * (to - from));
    from = to;
  }
  return goals;
}

TYPED_TEST(TickTest, IsTheIndependentLoopTickByTick) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(3);
  int in_contact = 0;
  int in_free_space = 0;
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    Loop<D> loop = random_stable_loop<D>(random);
    if (i % 4 == 0) loop.setting.stiffnesses.k_c = infinity;
    if (slowest_mode(loop) > 0.998) continue;
    const TickCoefficients<D> coefficients = loop.coefficients();
    const std::vector<Vector<D>> goals = script(loop, random, 6, 150);
    TickState<D> state = state_at_start(goals[0]);
    const PerStrategy<ReferenceLoop> loops = reference_loops(loop);
    PerStrategy<ReferenceState> expected;
    expected.fill(reference_start(reference(goals[0])));
    const ReferenceMatrix P_A = reference_projector<D>(loop.setting.motors);
    const ReferenceVector n = reference(loop.setting.wall.normal);

    struct Worst {
      double device = 0.0, proxy = 0.0, force = 0.0, energy = 0.0;
    };
    PerStrategy<Worst> error;
    PerStrategy<Worst> size;
    for (std::size_t k = 1; k < goals.size(); ++k) {
      tick(coefficients, goals[k], state);
      for (std::size_t s = 0; s < strategy_count; ++s) {
        expected[s] = reference_tick(loops[s], expected[s], reference(goals[k]));
      }
      const SnapshotIn<D> snapshot = snapshot_of(coefficients, state);
      ASSERT_EQ(snapshot.tick, static_cast<std::int64_t>(k));
      ASSERT_EQ(snapshot.goal, goals[k]);
      const auto& full = expected[index_of(StrategyId::full)];
      for (std::size_t s = 0; s < strategy_count; ++s) {
        const auto& actual = snapshot.strategies[s];
        const auto& wanted = expected[s];
        const auto grow = [](double& worst, double value) { worst = std::max(worst, value); };
        grow(error[s].device, distance(actual.device, wanted.device));
        grow(error[s].proxy, distance(actual.proxy, wanted.proxy));
        grow(error[s].force, distance(actual.force, wanted.force));
        grow(error[s].energy, std::abs(actual.energy - static_cast<double>(wanted.energy)));
        grow(size[s].device, static_cast<double>(wanted.device.norm()));
        grow(size[s].proxy, static_cast<double>(wanted.proxy.norm()));
        grow(size[s].force, static_cast<double>(wanted.force.norm()));
        grow(size[s].energy, std::abs(static_cast<double>(wanted.energy)));
        ++(actual.in_contact ? in_contact : in_free_space);
        // Derived values of the same tick.
        if (actual.in_contact) {
          const ReferenceVector slid = wanted.proxy - reference(goals[k]);
          const double tiny = 1e-9 * extent(loop);
          EXPECT_LE(distance(actual.ghost_force, ReferenceVector(P_A * (wanted.force - full.force))),
                    tiny * loop.setting.stiffnesses.k_r);
          EXPECT_LE(distance(actual.proxy_drift, ReferenceVector(slid - n * n.dot(slid))), tiny);
        } else {
          EXPECT_EQ(actual.ghost_force, Vector<D>(0.0));
          EXPECT_EQ(actual.proxy_drift, Vector<D>(0.0));
        }
      }
    }
    // 1e-9 of the greatest value on the path: what the program promises of two implementations. Rounding alone needs
    // far less, 500 remembered ticks times a few ε.
    for (std::size_t s = 0; s < strategy_count; ++s) {
      SCOPED_TRACE(strategy_catalog()[s].name);
      EXPECT_LE(error[s].device, 1e-9 * size[s].device);
      EXPECT_LE(error[s].proxy, 1e-9 * size[s].proxy);
      EXPECT_LE(error[s].force, 1e-9 * size[s].force);
      EXPECT_LE(error[s].energy, 1e-9 * size[s].energy);
    }
  }
  EXPECT_GT(in_contact, 10000);  // the paths meet both sides
  EXPECT_GT(in_free_space, 1000);
}

// Nothing is missing where n is a direction that a motor pushes along: naïve and anisotropic are one, at every tick.
TYPED_TEST(TickTest, NaiveIsAnisotropicWhereTheNormalIsActuated) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    SCOPED_TRACE(i);
    Loop<D> loop = random_stable_loop<D>(random);
    const Setting<D> turned = random_setting_with_actuated_normal<D>(random);
    loop.setting.wall = turned.wall;
    loop.setting.motors = turned.motors;
    loop.setting.goal = turned.goal;
    if (slowest_mode(loop) > 0.998) continue;
    const TickCoefficients<D> coefficients = loop.coefficients();
    const std::vector<Vector<D>> goals = script(loop, random, 4, 200);
    TickState<D> state = state_at_start(goals[0]);
    // P_N n is a few ε instead of 0, which ρ multiplies and 500 remembered ticks add up: 1e-11 of the extent.
    const double tolerance = 1e-11 * extent(loop);
    for (std::size_t k = 1; k < goals.size(); ++k) {
      tick(coefficients, goals[k], state);
      const auto& naive = state.strategies[index_of(StrategyId::naive)];
      const auto& anisotropic = state.strategies[index_of(StrategyId::anisotropic)];
      ASSERT_LE(glm::length(naive.motion.position - anisotropic.motion.position), tolerance);
      ASSERT_LE(glm::length(naive.proxy - anisotropic.proxy), tolerance);
    }
    // And both join the fully actuated one at rest.
    for (std::int64_t k = ticks_to_rest(loop); k > 0; --k) tick(coefficients, loop.setting.goal, state);
    const auto& full = state.strategies[index_of(StrategyId::full)];
    for (const StrategyId id : {StrategyId::naive, StrategyId::anisotropic}) {
      const auto& other = state.strategies[index_of(id)];
      EXPECT_LE(glm::length(other.motion.position - full.motion.position), 10.0 * tolerance);
      EXPECT_LE(glm::length(other.proxy - full.proxy), 10.0 * tolerance);
    }
  }
}

// Where the projector is exact in binary, so is the agreement: bit for bit.
TEST(Tick, NaiveIsAnisotropicBitForBitOnAnAxis) {
  const Wall<2> wall{{0.0, 0.0}, {-1.0, 0.0}};
  const TickCoefficients<2> coefficients = coefficients_of(
      wall, actuated_along(Vector<2>{1.0, 0.0}), make_stiffnesses(100.0, 700.0, 900.0, 1e5), 0.1, 5.0, 1000.0);
  TickState<2> state = state_at_start(Vector<2>{-0.01, 0.0});
  for (int k = 1; k <= 1000; ++k) {
    tick(coefficients, Vector<2>{-0.01 + 4e-5 * k, 1e-5 * k}, state);
    const auto& naive = state.strategies[index_of(StrategyId::naive)];
    const auto& anisotropic = state.strategies[index_of(StrategyId::anisotropic)];
    ASSERT_EQ(naive.motion.position, anisotropic.motion.position);
    ASSERT_EQ(naive.proxy, anisotropic.proxy);
    ASSERT_EQ(naive.energy, anisotropic.energy);
  }
  EXPECT_TRUE(state.strategies[index_of(StrategyId::naive)].in_contact);
}

// --- The wall's one side, and the first tick -------------------------------------------------------------------------

TYPED_TEST(TickTest, StartsAtTheGoalAndAtRest) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(5);
  const Loop<D> loop = random_stable_loop<D>(random);
  const SnapshotIn<D> snapshot = snapshot_of(loop.coefficients(), state_at_start(loop.setting.goal));  // inside it
  EXPECT_EQ(snapshot.tick, 0);
  EXPECT_EQ(snapshot.time_s, 0.0);
  EXPECT_EQ(snapshot.goal, loop.setting.goal);
  for (const auto& strategy : snapshot.strategies) {
    EXPECT_EQ(strategy.device, loop.setting.goal);
    EXPECT_EQ(strategy.proxy, loop.setting.goal);
    EXPECT_EQ(strategy.force, Vector<D>(0.0));
    EXPECT_EQ(strategy.ghost_force, Vector<D>(0.0));
    EXPECT_EQ(strategy.proxy_drift, Vector<D>(0.0));
    EXPECT_EQ(strategy.energy, 0.0);
    EXPECT_FALSE(strategy.in_contact);
  }
}

// The proxy of tick k is that of the device of tick k − 1: in contact behind the wall, in free space the device itself,
// where the force is then −K_r dt v_k and no more.
TYPED_TEST(TickTest, WallActsOnOneSideAndOneTickLate) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(6);
  int entered = 0;
  int left = 0;
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const Loop<D> loop = random_stable_loop<D>(random);
    const TickCoefficients<D> coefficients = loop.coefficients();
    const std::vector<Vector<D>> goals = script(loop, random, 6, 400);
    TickState<D> state = state_at_start(goals[0]);
    for (std::size_t k = 1; k < goals.size(); ++k) {
      const TickState<D> before = state;
      tick(coefficients, goals[k], state);
      const SnapshotIn<D> snapshot = snapshot_of(coefficients, state);
      for (std::size_t s = 0; s < strategy_count; ++s) {
        const Vector<D>& device_before = before.strategies[s].motion.position;
        const auto& now = snapshot.strategies[s];
        const bool inside = glm::dot(loop.setting.wall.normal, device_before - loop.setting.wall.point) < 0.0;
        ASSERT_EQ(now.in_contact, inside);
        entered += now.in_contact && !before.strategies[s].in_contact;
        left += !now.in_contact && before.strategies[s].in_contact;
        if (inside) {
          // Never pulled in: the proxy is on the free side of the device that it is computed from.
          ASSERT_GE(glm::dot(loop.setting.wall.normal, now.proxy - device_before), 0.0);
        } else {
          ASSERT_EQ(now.proxy, device_before);
          const Vector<D> lag = coefficients.strategies[s].rendering *
                                (-coefficients.device.period * state.strategies[s].motion.velocity);
          // A difference of positions, times k_r.
          ASSERT_LE(glm::length(now.force - lag), 8.0 * epsilon * extent(loop) * loop.setting.stiffnesses.k_r);
        }
      }
    }
  }
  EXPECT_GT(entered, 50);
  EXPECT_GT(left, 50);
}

}  // namespace
}  // namespace ghostforce::tick_test
