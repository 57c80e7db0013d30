#include "core/target_reading.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/prediction.h"
#include "core/tick.h"
#include "core/user_measurement.h"
#include "tests/core/dimensions.h"
#include "tests/core/random_setting.h"

namespace ghostforce::target_reading_test {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

template <glm::length_t D>
StrategySnapshot<D> snapshot_of_rest(const Equilibrium<D>& rest) {
  StrategySnapshot<D> now;
  now.device = rest.device;
  now.proxy = rest.proxy;
  now.contact = rest.contact;
  now.force = rest.force;
  now.in_contact = rest.in_contact;
  return now;
}

// What the reading is not to depend on.
Stiffnesses with_another_hand(Stiffnesses stiffnesses, Random& random) {
  stiffnesses.k_u = random.over_decades(1.0, 1e4);
  stiffnesses.believed_k_u = random.over_decades(1.0, 1e4);
  return stiffnesses;
}

template <glm::length_t D>
bool tells_the_hand(const Setting<D>& setting) {
  return drift_direction(setting.wall, setting.actuation()) != Vector<D>(0.0);
}

// The device gives everything through differences of positions of up to 0.3 m, from which 1/k_u is divided out of a way
// of f_r/k_u: the error is that of the positions beside this way.
template <glm::length_t D>
double tolerance(const Setting<D>& setting, const Equilibrium<D>& rest) {
  const double sideways = glm::length(along(setting.wall, rest.device - rest.goal));
  return 2000.0 * epsilon * (1.0 + 0.1 / sideways);
}

template <typename Dimension>
class TargetReadingTest : public testing::Test {};
TYPED_TEST_SUITE(TargetReadingTest, Dimensions, DimensionName);

// The goal is known to the test alone; the reading has a point on its normal, and neither k_u nor depth.
TYPED_TEST(TargetReadingTest, IsTheGhostForceOfTheTrueGoalWhateverIsBelieved) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(11);
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    if (!tells_the_hand(setting) || depth(setting.wall, setting.goal) < 1e-3) continue;
    const Actuation<D> actuation = setting.actuation();
    const Equilibrium<D> rest =
        equilibrium_with_ratio(setting.wall, actuation, setting.stiffnesses, setting.ratio, setting.goal);
    const Vector<D> full = equilibrium_fully_actuated(setting.wall, setting.stiffnesses, setting.goal).force;
    const Vector<D> expected = ghost_force(actuation, rest.force, full);
    const TargetReading<D> reading = read_against_target(
        strategy(StrategyId::anisotropic), setting.wall, actuation, with_another_hand(setting.stiffnesses, random),
        projection(setting.wall, setting.goal), snapshot_of_rest(rest));
    const double size = glm::length(rest.force) + glm::length(full);
    EXPECT_LE(glm::distance(reading.ghost_force, expected), tolerance(setting, rest) * size);
    const Vector<D> drift = proxy_drift(setting.wall, rest.proxy, setting.goal);
    EXPECT_LE(glm::distance(reading.proxy_drift, drift), 1e-15 + 100.0 * epsilon * glm::length(rest.proxy));
    ++compared;
  }
  EXPECT_GT(compared, 2000);
}

// ghost force = k_r P_A drift / (1 + κ + k_t/k_c)
TYPED_TEST(TargetReadingTest, IsProportionalToTheDriftInClosedForm) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(12);
  for (int i = 0; i < 3000; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    if (!tells_the_hand(setting) || depth(setting.wall, setting.goal) < 1e-3) continue;
    const Actuation<D> actuation = setting.actuation();
    const Stiffnesses& k = setting.stiffnesses;
    const Equilibrium<D> rest = equilibrium_with_ratio(setting.wall, actuation, k, setting.ratio, setting.goal);
    const TargetReading<D> reading =
        read_against_target(strategy(StrategyId::naive), setting.wall, actuation, k,
                            projection(setting.wall, setting.goal), snapshot_of_rest(rest));
    const Vector<D> closed =
        (actuation.actuated * reading.proxy_drift) * (k.k_r / (1.0 + k.k_r / k.k_u + k.k_t / k.k_c));
    const double size = glm::length(rest.force) + glm::length(closed);
    EXPECT_LE(glm::distance(reading.ghost_force, closed), tolerance(setting, rest) * size);
  }
}

struct Example {
  Wall<2> wall{{0.0, 0.0}, direction_at(2.356194490192345)};
  Actuation<2> actuation = actuated_along(Vector<2>(1.0, 0.0));
  Stiffnesses k = make_stiffnesses(100.0, 1000.0, 1000.0, 1e5);
  Vector<2> goal{0.040, -0.040};

  TargetReading<2> read(StrategyId id, const Stiffnesses& used, const Vector<2>& target) const {
    const Equilibrium<2> rest = equilibrium_of(strategy(id), wall, actuation, used, goal);
    return read_against_target(strategy(id), wall, actuation, used, target, snapshot_of_rest(rest));
  }
};

// The numbers of docs/theory.md: the naïve force −6.656 N beside −3.633 N.
TEST(TargetReading, HasTheNumbersOfTheExample) {
  const Example example;
  const TargetReading<2> naive = example.read(StrategyId::naive, example.k, {0.0, 0.0});
  EXPECT_NEAR(naive.ghost_force.x, -6.656 + 3.633, 1e-3);
  EXPECT_NEAR(naive.ghost_force.y, 0.0, 1e-12);
  const TargetReading<2> cured = example.read(StrategyId::anisotropic, example.k, {0.0, 0.0});
  EXPECT_NEAR(glm::length(cured.ghost_force), 0.0, 1e-11);
  EXPECT_NEAR(glm::length(cured.proxy_drift), 0.0, 1e-15);
}

// Against the goal that is inferred with the belief, the wrong belief would not show at all.
TEST(TargetReading, ShowsAWrongBelief) {
  Example example;
  example.k.believed_k_u = 400.0;
  const Equilibrium<2> rest =
      equilibrium_of(strategy(StrategyId::anisotropic), example.wall, example.actuation, example.k, example.goal);
  Stiffnesses believed = example.k;
  believed.k_u = 400.0;
  const Vector<2> inferred = rest.device - rest.force / believed.k_u;
  const Vector<2> full = equilibrium_fully_actuated(example.wall, believed, inferred).force;
  EXPECT_NEAR(glm::length(ghost_force(example.actuation, rest.force, full)), 0.0, 1e-9);
  const TargetReading<2> reading = example.read(StrategyId::anisotropic, example.k, {0.0, 0.0});
  EXPECT_GT(glm::length(reading.ghost_force), 1.0);
  EXPECT_GT(glm::length(reading.proxy_drift), 0.010);
}

TEST(TargetReading, TheFullyActuatedStrategyHasNoExcessOverItself) {
  const Example example;
  const TargetReading<2> beside = example.read(StrategyId::full, example.k, 0.003 * Vector<2>(1.0, 1.0));
  EXPECT_EQ(beside.ghost_force, Vector<2>(0.0));
  EXPECT_NEAR(glm::length(beside.proxy_drift), 0.003 * std::sqrt(2.0), 1e-15) << "who aims beside it drifts";
}

TEST(TargetReading, SaysThatItIsNotKnown) {
  Example example;
  // A target far on the other side: no spring pulls there.
  const Vector<2> beside = 0.2 * Vector<2>(-1.0, -1.0);
  const bool first = std::isnan(example.read(StrategyId::naive, example.k, beside).ghost_force.x);
  const bool second = std::isnan(example.read(StrategyId::naive, example.k, -beside).ghost_force.x);
  EXPECT_NE(first, second) << "on one of the two sides the hand would push, not pull";
  // No force along the wall: n lies along the motor.
  example.wall.normal = {0.0, 1.0};
  example.actuation = actuated_along(example.wall.normal);
  EXPECT_TRUE(std::isnan(example.read(StrategyId::naive, example.k, {0.0, 0.0}).ghost_force.x));
}

// The loop of a measured device, with a hand of 100 N/m behind it of which the program believes 250 N/m.
TEST(TargetReading, OfTheLoopAtRestIsThatOfTheHandBehindIt) {
  const Example example;
  Stiffnesses k = example.k;
  k.believed_k_u = 250.0;
  const auto coefficients = coefficients_of(example.wall, example.actuation, k, 0.1, 5.0, 1000.0);
  const Equilibrium<2> rest =
      equilibrium_of(strategy(StrategyId::anisotropic), example.wall, example.actuation, k, example.goal);
  TickState<2> state = state_at_start(rest.device);
  for (int i = 0; i < 3; ++i) {
    tick_with_device(coefficients, StrategyId::anisotropic, rest.device, rest.force, 250.0, state);
  }
  const SnapshotIn<2> snapshot = snapshot_of(coefficients, state);
  const StrategySnapshot<2>& now = snapshot.strategies[index_of(StrategyId::anisotropic)];
  EXPECT_NEAR(glm::distance(now.force, rest.force), 0.0, 1e-9);
  const TargetReading<2> reading =
      read_against_target(strategy(StrategyId::anisotropic), example.wall, example.actuation, k, {0.0, 0.0}, now);
  const Vector<2> full = equilibrium_fully_actuated(example.wall, k, example.goal).force;
  EXPECT_NEAR(glm::distance(reading.ghost_force, ghost_force(example.actuation, rest.force, full)), 0.0, 1e-9);
}

}  // namespace
}  // namespace ghostforce::target_reading_test
