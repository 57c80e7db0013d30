#include "core/user_measurement.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/equilibrium.h"
#include "core/ghost_force.h"
#include "core/tick.h"
#include "tests/core/random_setting.h"

namespace ghostforce::user_measurement_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// A rest in the plane, with n well between along and across the motor.
struct PlaneRest {
  Wall<2> wall;
  Actuation<2> actuation;
  Stiffnesses k;
  double ratio;
  Vector<2> goal;

  RestState<2> state() const {
    const Equilibrium<2> rest = equilibrium_with_ratio(wall, actuation, k, ratio, goal);
    return {goal, rest.device, rest.proxy, rest.force, ratio};
  }
};

PlaneRest random_equilibrium(Random& random) {
  PlaneRest rest;
  const double motor = random.uniform(-4.0, 4.0);
  const double quarter = random.below(4) * std::numbers::pi / 2.0;
  rest.wall = {random.in_box<2>(0.05), direction_at(motor + quarter + random.uniform(0.2, 1.3))};
  rest.actuation = actuated_along(direction_at(motor));
  rest.k = make_stiffnesses(random.over_decades(20.0, 2000.0), random.over_decades(20.0, 2000.0),
                            random.over_decades(20.0, 5000.0),
                            random.once_in(3) ? infinity : random.over_decades(100.0, 1e6));
  rest.ratio = random.over_decades(0.1, 30.0);
  rest.goal = projection(rest.wall, random.in_box<2>(0.05)) - random.uniform(0.005, 0.05) * rest.wall.normal;
  return rest;
}

TEST(UserMeasurementTest, OneRestAtAnyRatioTellsTheUser) {
  Random random(1);
  int above = 0;
  int below = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const PlaneRest rest = random_equilibrium(random);
    const UserReading reading = read_user(rest.wall, rest.actuation, rest.state());
    ASSERT_EQ(reading.problem, NoReading::none);
    const double null_ratio = optimal_tracking_ratio(rest.k.k_r, rest.k.k_u);
    // Of some tens of roundings, the worst are the differences of positions (5 cm) beside the way of the proxy, of
    // which P_A (q_p − q_h) is the least: a share k_u/(k_u + k_r) or more of a depth of 5 mm, over a soft wall less.
    const Equilibrium<2> at = equilibrium_with_ratio(rest.wall, rest.actuation, rest.k, rest.ratio, rest.goal);
    const double share = 0.05 / glm::length(rest.actuation.actuated * (at.proxy - at.device));
    const double tolerance = 100.0 * epsilon * (1.0 + share) * (null_ratio + rest.ratio) / 0.04;
    EXPECT_NEAR(reading.null_ratio, null_ratio, tolerance);
    EXPECT_NEAR(reading.k_u / rest.k.k_u, 1.0, 2.0 * tolerance * (1.0 + 1.0 / (null_ratio - 1.0)));
    // Positive below ρ°, negative above it, and as long as proxy_drift() has it.
    if (std::abs(rest.ratio - null_ratio) > 1e-6) {
      EXPECT_EQ(reading.drift > 0.0, rest.ratio < null_ratio);
    }
    EXPECT_NEAR(std::abs(reading.drift), glm::length(proxy_drift(rest.wall, at.proxy, rest.goal)), 1e-15);
    (rest.ratio < null_ratio ? below : above) += 1;
  }
  EXPECT_GT(above, 200);
  EXPECT_GT(below, 200);
}

TEST(UserMeasurementTest, ADriftThatIsGoneIsAtTheOptimalRatio) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    PlaneRest rest = random_equilibrium(random);
    rest.ratio = optimal_tracking_ratio(rest.k.k_r, rest.k.k_u);
    EXPECT_NEAR(read_user(rest.wall, rest.actuation, rest.state()).drift, 0.0, 1e-15);
    EXPECT_NEAR(user_stiffness_of(rest.k.k_r, rest.ratio) / rest.k.k_u, 1.0,
                4.0 * epsilon * (1.0 + rest.k.k_u / rest.k.k_r));
  }
}

// Any subspace of three dimensions; the aim may be any point over the goal's foot on the wall.
TEST(UserMeasurementTest, AFootOnTheWallIsAsGoodAsTheGoalInAnyDimension) {
  Random random(3);
  int read = 0;
  for (int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const Wall<3> wall{random.in_box<3>(0.05), random.direction<3>()};
    const std::array motors{random.direction<3>(), random.direction<3>()};
    const Actuation<3> actuation =
        actuated_along<3>(std::span(motors).first(static_cast<std::size_t>(1 + random.below(2))));
    const double alpha = glm::dot(wall.normal, actuation.actuated * wall.normal);
    if (alpha < 0.05 || alpha > 0.95) continue;
    const Stiffnesses k = make_stiffnesses(150.0, 600.0, 900.0, 1e5);
    const double ratio = random.over_decades(0.5, 20.0);
    const Vector<3> goal = projection(wall, random.in_box<3>(0.05)) - 0.02 * wall.normal;
    const Equilibrium<3> at = equilibrium_with_ratio(wall, actuation, k, ratio, goal);
    const Vector<3> target = projection(wall, goal);
    const UserReading reading = read_user(wall, actuation, RestState<3>{target, at.device, at.proxy, at.force, ratio});
    ASSERT_EQ(reading.problem, NoReading::none);
    EXPECT_NEAR(reading.k_u, 150.0, 150.0 * 1e-10);  // differences of centimetres, to 1e-16, over millimetres
    ++read;
  }
  EXPECT_GT(read, 300);
}

// With dynamics and sampling, on either side of ρ°, for hard and soft walls.
TEST(UserMeasurementTest, TheSimulatedLoopAtRestTellsItsUser) {
  for (const double k_c : {500.0, 1e5, infinity}) {
    for (const double k_u : {80.0, 200.0, 700.0}) {
      for (const double ratio : {1.0, 3.0, 12.0}) {
        SCOPED_TRACE(testing::Message() << "k_c " << k_c << ", k_u " << k_u << ", ratio " << ratio);
        Stiffnesses k = make_stiffnesses(k_u, 600.0, 600.0, k_c);
        k.chosen_tracking_ratio = ratio;
        const Wall<2> wall{{0.0, 0.0}, direction_at(2.3)};
        const Actuation<2> actuation = actuated_along(Vector<2>{1.0, 0.0});
        const TickCoefficients<2> coefficients = coefficients_of(wall, actuation, k, 0.1, 5.0, 1000.0);
        const Vector<2> goal = -0.02 * wall.normal + along(wall, Vector<2>(0.01, 0.0));
        TickState<2> state = state_at_start(goal);
        for (int i = 0; i < 4000; ++i) tick(coefficients, goal, state);
        const Snapshot snapshot = snapshot_of(coefficients, state);
        const auto& now = snapshot.strategies[index_of(StrategyId::anisotropic)];
        const UserReading reading =
            read_user(wall, actuation, RestState<2>{goal, now.device, now.proxy, now.force, ratio});
        ASSERT_EQ(reading.problem, NoReading::none);
        // The slowest motion dies out with b/k_u = 63 ms or faster: e^-60 after 4 s; what is left is rounding.
        EXPECT_NEAR(reading.k_u, k_u, 1e-9 * k_u);
      }
    }
  }
}

TEST(UserMeasurementTest, SaysWhyThereIsNoReading) {
  const Wall<2> wall{{0.0, 0.0}, direction_at(2.3)};
  const Actuation<2> actuation = actuated_along(Vector<2>{1.0, 0.0});
  const Stiffnesses k = make_stiffnesses(100.0, 600.0, 600.0, 1e5);
  const Vector<2> goal = -0.02 * wall.normal;
  const Equilibrium<2> at = equilibrium_with_ratio(wall, actuation, k, 3.0, goal);
  const RestState<2> good{goal, at.device, at.proxy, at.force, 3.0};
  EXPECT_EQ(read_user(wall, actuation, good).problem, NoReading::none);

  RestState<2> rest = good;
  rest.device = 0.001 * wall.normal;
  EXPECT_EQ(read_user(wall, actuation, rest).problem, NoReading::no_contact);
  rest = good;
  rest.force = Vector<2>(0.0);
  EXPECT_EQ(read_user(wall, actuation, rest).problem, NoReading::no_rendering);
  rest = good;
  // A hand that aimed a hand's breadth aside: the drift goes the wrong way.
  rest.aim += 0.1 * drift_direction(wall, actuation);
  EXPECT_EQ(read_user(wall, actuation, rest).problem, NoReading::no_such_hand);
  rest.aim.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(read_user(wall, actuation, rest).problem, NoReading::no_such_hand);
  for (const double angle : {0.0, 0.08, 1.6, -1.53, 3.1}) {
    const Wall<2> facing{{0.0, 0.0}, direction_at(angle)};
    EXPECT_EQ(read_user(facing, actuation, good).problem, NoReading::no_drift_at_all) << angle;
    EXPECT_EQ(drift_direction(facing, actuation), Vector<2>(0.0)) << angle;
  }
  for (const NoReading problem : {NoReading::no_contact, NoReading::no_drift_at_all, NoReading::no_rendering,
                                  NoReading::no_such_hand, NoReading::limited}) {
    EXPECT_TRUE(sentence_of(problem).ends_with('.'));
  }
}

TEST(UserMeasurementTest, SpreadIsMedianAndQuartiles) {
  const std::vector<double> five{105.0, 90.0, 100.0, 140.0, 95.0};
  const Spread spread = spread_of(five);
  EXPECT_EQ(spread.median, 100.0);
  EXPECT_EQ(spread.lower_quartile, 95.0);   // the second
  EXPECT_EQ(spread.upper_quartile, 105.0);  // the fourth
  const std::vector<double> two{1.0, 2.0};
  EXPECT_EQ(spread_of(two).median, 1.5);
  EXPECT_EQ(spread_of(two).lower_quartile, 1.25);
  const std::vector<double> one{7.0};
  EXPECT_EQ(spread_of(one).upper_quartile, 7.0);
  EXPECT_EQ(spread_of(std::span<const double>()).median, 0.0);
}

TEST(RestWatchTest, CountsFromWhenItStayedNear) {
  RestWatch<2> watch(0.001);
  EXPECT_EQ(watch.held_s(), 0.0);
  watch.see(1.0, {0.0, 0.0});
  watch.see(1.5, {0.0009, 0.0});
  EXPECT_EQ(watch.held_s(), 0.5);
  watch.see(1.75, {0.0, 0.0011});  // too far from where it was at first
  EXPECT_EQ(watch.held_s(), 0.0);
  watch.see(2.0, {0.0, 0.0011});
  EXPECT_EQ(watch.held_s(), 0.25);
  watch.see(0.5, {0.0, 0.0011});  // another run
  EXPECT_EQ(watch.held_s(), 0.0);
  watch.see(1.0, {NAN, 0.0});
  EXPECT_EQ(watch.held_s(), 0.0);
  watch.forget();
  EXPECT_EQ(watch.held_s(), 0.0);
}

}  // namespace
}  // namespace ghostforce::user_measurement_test
