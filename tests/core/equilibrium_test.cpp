#include "core/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/ghost_force.h"
#include "tests/core/dimensions.h"
#include "tests/core/linear_equilibrium.h"
#include "tests/core/random_setting.h"
#include "tests/core/reference_model.h"

namespace ghostforce::equilibrium_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr int settings_per_test = 2000;

// How far rounding alone may carry a closed form from the exact answer. With
//     r = o − q_u,   κ = k_r/k_u,   α = nᵀP_A n
//     σ = (1+κ) α + ρ (1−α) + k_t/k_c
//     g = (1+κ+ρ)/σ
// and in units of one rounding ε
//     d = n·r                       is good to  |r|
//     u = (1+κ) P_A n + ρ P_N n     is good to  1+κ+ρ,  and |u| ≤ √((1+κ+ρ) σ)
//     q_p = q_u + d u/σ             is good to  |o| + |q_u| + |r| + |r| g (1 + √g)
//     f_r = k_r d P_A n/σ           is good to  k_r |r| (1 + g)/σ
//     q_h = q_u + f_r/k_u           is good to  |o| + |q_u| + |r|,  and that of f_r over k_u
// Each chain is a dozen roundings long and has D terms in each product: 32 ε holds it, with a factor of 3 to spare.
struct Rounding {
  template <glm::length_t D>
  Rounding(const Wall<D>& wall, const Matrix<D>& P_A, const Stiffnesses& k, double ratio, const Vector<D>& goal) {
    const double kappa = k.k_r / k.k_u;
    const double alpha = glm::dot(wall.normal, P_A * wall.normal);
    const double sigma = (1.0 + kappa) * alpha + ratio * (1.0 - alpha) + k.k_t / k.k_c;
    const double reach = glm::length(wall.point - goal);
    const double scale = glm::length(wall.point) + glm::length(goal) + reach;
    const double g = (1.0 + kappa + ratio) / sigma;
    proxy = 32.0 * epsilon * (scale + reach * g * (1.0 + std::sqrt(g)));
    force = 32.0 * epsilon * k.k_r * reach * (1.0 + g) / sigma;
    device = force / k.k_u + 32.0 * epsilon * scale;
  }

  Rounding worse_by(double factor) const {
    Rounding worse = *this;
    worse.proxy *= factor;
    worse.force *= factor;
    worse.device *= factor;
    return worse;
  }

  double proxy;   // [m]
  double force;   // [N]
  double device;  // [m]
};

template <glm::length_t D>
Rounding fully_actuated_rounding(const Setting<D>& setting) {
  return {setting.wall, Matrix<D>(1.0), setting.stiffnesses, 1.0, setting.goal};
}

template <glm::length_t D>
Rounding underactuated_rounding(const Setting<D>& setting, double ratio) {
  return {setting.wall, setting.actuation().actuated, setting.stiffnesses, ratio, setting.goal};
}

template <glm::length_t D>
void expect_equilibrium(const Equilibrium<D>& actual, const ReferenceEquilibrium& expected, const Rounding& rounding) {
  EXPECT_LE(distance(actual.proxy, expected.proxy), rounding.proxy);
  EXPECT_LE(distance(actual.device, expected.device), rounding.device);
  EXPECT_LE(distance(actual.force, expected.force), rounding.force);
  EXPECT_TRUE(actual.in_contact);
}

template <glm::length_t D>
double optimal_ratio(const Setting<D>& setting) {
  return 1.0 + setting.stiffnesses.k_r / setting.stiffnesses.k_u;
}

template <typename Dimension>
class EquilibriumTest : public testing::Test {};
TYPED_TEST_SUITE(EquilibriumTest, Dimensions, DimensionName);

// --- Against the balance of forces, solved by Eigen ------------------------------------------------------------------

TYPED_TEST(EquilibriumTest, AnyRatioBalancesTheForces) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(1);
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const auto rest =
        equilibrium_with_ratio(setting.wall, setting.actuation(), setting.stiffnesses, setting.ratio, setting.goal);
    expect_equilibrium(rest,
                       reference_equilibrium(underactuated_reference(setting, setting.ratio), reference(setting.goal)),
                       underactuated_rounding(setting, setting.ratio));
  }
}

TYPED_TEST(EquilibriumTest, FullyActuatedBalancesTheForces) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(2);
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    expect_equilibrium(equilibrium_fully_actuated(setting.wall, setting.stiffnesses, setting.goal),
                       reference_equilibrium(fully_actuated_reference(setting), reference(setting.goal)),
                       fully_actuated_rounding(setting));
  }
}

TYPED_TEST(EquilibriumTest, NaiveBalancesTheForces) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(3);
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    expect_equilibrium(equilibrium_naive(setting.wall, setting.actuation(), setting.stiffnesses, setting.goal),
                       reference_equilibrium(underactuated_reference(setting, 1.0L), reference(setting.goal)),
                       underactuated_rounding(setting, 1.0));
  }
}

TYPED_TEST(EquilibriumTest, AnisotropicBalancesTheForces) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(4);
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Extended ratio = 1.0L + Extended{setting.stiffnesses.k_r} / setting.stiffnesses.k_u;
    expect_equilibrium(equilibrium_anisotropic(setting.wall, setting.actuation(), setting.stiffnesses, setting.goal),
                       reference_equilibrium(underactuated_reference(setting, ratio), reference(setting.goal)),
                       underactuated_rounding(setting, optimal_ratio(setting)));
  }
}

// Elimination in double precision pays for the condition of the system where the closed form does not: K_t is worse by
// ρ + 1/ρ, and eliminating q_h takes K_r (k_u I + K_r)⁻¹ K_r, that is almost all, from K_r, which costs 1 + κ.
TYPED_TEST(EquilibriumTest, LinearSolveBalancesTheForces) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(5);
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Stiffnesses& k = setting.stiffnesses;
    const Coupling<D> coupling = underactuated_coupling(k.k_r, k.k_t, setting.ratio, setting.actuation());
    expect_equilibrium(equilibrium_by_linear_solve(setting.wall, coupling, k.k_u, k.k_c, setting.goal),
                       reference_equilibrium(underactuated_reference(setting, setting.ratio), reference(setting.goal)),
                       underactuated_rounding(setting, setting.ratio)
                           .worse_by(optimal_ratio(setting) * (setting.ratio + 1.0 / setting.ratio)));
  }
}

// The catalog's strategies, with the ratio that each runs with; a belief may be wrong and a ratio chosen.
TYPED_TEST(EquilibriumTest, StrategiesBalanceTheForces) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(6);
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    Setting<D> setting = random_setting<D>(random);
    Stiffnesses& k = setting.stiffnesses;
    if (random.once_in(2)) k.believed_k_u = k.k_u * random.over_decades(0.1, 10.0);
    if (random.once_in(4)) k.chosen_tracking_ratio = setting.ratio;
    const double ratio = k.chosen_tracking_ratio.value_or(1.0 + k.k_r / k.believed_k_u.value_or(k.k_u));
    const auto equilibrium_with = [&](StrategyId id) {
      return equilibrium_of(strategy(id), setting.wall, setting.actuation(), k, setting.goal);
    };
    const ReferenceVector goal = reference(setting.goal);
    expect_equilibrium(equilibrium_with(StrategyId::full),
                       reference_equilibrium(fully_actuated_reference(setting), goal),
                       fully_actuated_rounding(setting));
    expect_equilibrium(equilibrium_with(StrategyId::naive),
                       reference_equilibrium(underactuated_reference(setting, 1.0L), goal),
                       underactuated_rounding(setting, 1.0));
    expect_equilibrium(equilibrium_with(StrategyId::anisotropic),
                       reference_equilibrium(underactuated_reference(setting, ratio), goal),
                       underactuated_rounding(setting, ratio));
  }
}

// (3): the contact is on the wall, and straight above or below the proxy.
TYPED_TEST(EquilibriumTest, ContactIsTheProxyProjectedOnTheWall) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(7);
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Stiffnesses& k = setting.stiffnesses;
    const auto rest = equilibrium_with_ratio(setting.wall, setting.actuation(), k, setting.ratio, setting.goal);
    const double rounding = underactuated_rounding(setting, setting.ratio).proxy;
    EXPECT_NEAR(glm::dot(setting.wall.normal, rest.contact - setting.wall.point), 0.0, rounding);
    EXPECT_LE(glm::length(along(setting.wall, rest.contact - rest.proxy)), rounding);
    // The proxy lies between the goal's depth and the wall: it is on a hard wall, and a little inside a soft one.
    EXPECT_GE(depth(setting.wall, rest.proxy), -rounding);
    EXPECT_LE(depth(setting.wall, rest.proxy), depth(setting.wall, setting.goal) + rounding);
    if (std::isinf(k.k_c)) {
      EXPECT_LE(glm::length(rest.contact - rest.proxy), rounding);
    }
  }
}

// --- What the strategies promise -------------------------------------------------------------------------------------

// The cure: no ghost force and no drift for any wall (soft too), any dimension, any subspace.
TYPED_TEST(EquilibriumTest, AnisotropicHasNoGhostForceAndNoDrift) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(8);
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Actuation<D> actuation = setting.actuation();
    const Rounding rounding = underactuated_rounding(setting, optimal_ratio(setting));
    const auto full = equilibrium_fully_actuated(setting.wall, setting.stiffnesses, setting.goal);
    for (const Equilibrium<D>& rest :
         {equilibrium_anisotropic(setting.wall, actuation, setting.stiffnesses, setting.goal),
          equilibrium_with_ratio(setting.wall, actuation, setting.stiffnesses, optimal_ratio(setting), setting.goal)}) {
      EXPECT_LE(glm::length(ghost_force(actuation, rest.force, full.force)),
                rounding.force + fully_actuated_rounding(setting).force);
      EXPECT_LE(glm::length(proxy_drift(setting.wall, rest.proxy, setting.goal)), rounding.proxy);
    }
  }
}

// The disease: with n neither in the actuated subspace nor across it, the naïve force is too large by
// (1 + κ + k_t/k_c)/(1 + κα + k_t/k_c), along P_A n, and the proxy slides.
TYPED_TEST(EquilibriumTest, NaiveHasGhostForceAndDrift) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(9);
  int tried = 0;
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Stiffnesses& k = setting.stiffnesses;
    const Actuation<D> actuation = setting.actuation();
    const double alpha = glm::dot(setting.wall.normal, actuation.actuated * setting.wall.normal);
    const double kappa = k.k_r / k.k_u;
    if (alpha < 0.05 || alpha > 0.95 || kappa < 0.1) continue;
    ++tried;
    const auto full = equilibrium_fully_actuated(setting.wall, k, setting.goal);
    const auto naive = equilibrium_naive(setting.wall, actuation, k, setting.goal);
    const Vector<D> ghost = ghost_force(actuation, naive.force, full.force);
    const Vector<D> wanted = actuation.actuated * full.force;
    const double excess = (1.0 + kappa + k.k_t / k.k_c) / (1.0 + kappa * alpha + k.k_t / k.k_c) - 1.0;
    // Two forces, each good to its own rounding.
    const double rounding = underactuated_rounding(setting, 1.0).force + fully_actuated_rounding(setting).force;
    EXPECT_LE(glm::length(ghost - excess * wanted), rounding);
    EXPECT_GT(glm::length(ghost), 1000.0 * rounding);
    EXPECT_GT(glm::dot(ghost, setting.wall.normal), 0.0);
    EXPECT_GT(glm::length(proxy_drift(setting.wall, naive.proxy, setting.goal)),
              1000.0 * underactuated_rounding(setting, 1.0).proxy);
  }
  EXPECT_GT(tried, settings_per_test / 4);
}

// With n in the actuated subspace nothing is missing: all strategies agree, whatever the ratio.
TYPED_TEST(EquilibriumTest, AllAgreeWhereTheNormalIsActuated) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(10);
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting_with_actuated_normal<D>(random);
    const Actuation<D> actuation = setting.actuation();
    const auto full = equilibrium_fully_actuated(setting.wall, setting.stiffnesses, setting.goal);
    for (const double ratio : {1.0, optimal_ratio(setting), setting.ratio}) {
      const Rounding rounding = underactuated_rounding(setting, ratio).worse_by(2.0);
      const auto rest = equilibrium_with_ratio(setting.wall, actuation, setting.stiffnesses, ratio, setting.goal);
      EXPECT_LE(glm::length(rest.proxy - full.proxy), rounding.proxy);
      EXPECT_LE(glm::length(rest.device - full.device), rounding.device);
      EXPECT_LE(glm::length(rest.force - full.force), rounding.force);
    }
  }
}

// With n across the motors no device can push: no force, and the device stays at the goal.
TYPED_TEST(EquilibriumTest, NoForceWhereTheNormalIsNotActuated) {
  constexpr glm::length_t D = TypeParam::value;
  Setting<D> setting;
  setting.wall = {Vector<D>(0.0), Vector<D>(0.0)};
  setting.wall.normal[1] = 1.0;
  setting.motors = {Vector<D>(0.0)};
  setting.motors[0][0] = 1.0;
  setting.stiffnesses = make_stiffnesses(100.0, 1000.0, 1000.0, 1e5);
  setting.goal = Vector<D>(-0.01);
  for (const Strategy& entry : strategy_catalog()) {
    if (entry.has_every_motor) continue;
    const auto rest = equilibrium_of(entry, setting.wall, setting.actuation(), setting.stiffnesses, setting.goal);
    EXPECT_TRUE(rest.in_contact);
    EXPECT_EQ(rest.force, Vector<D>(0.0));
    EXPECT_EQ(rest.device, setting.goal);
    EXPECT_EQ(proxy_drift(setting.wall, rest.proxy, rest.goal), Vector<D>(0.0));
  }
}

// A hand believed softer than it is gets too large a ratio and too little force; one believed stiffer, the contrary.
TYPED_TEST(EquilibriumTest, WrongBeliefShows) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(11);
  int tried = 0;
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    Setting<D> setting = random_setting<D>(random);
    const Actuation<D> actuation = setting.actuation();
    const double alpha = glm::dot(setting.wall.normal, actuation.actuated * setting.wall.normal);
    if (alpha < 0.05 || alpha > 0.95 || setting.stiffnesses.k_r < 0.1 * setting.stiffnesses.k_u) continue;
    ++tried;
    const auto full = equilibrium_fully_actuated(setting.wall, setting.stiffnesses, setting.goal);
    for (const double belief : {0.5, 2.0}) {
      setting.stiffnesses.believed_k_u = belief * setting.stiffnesses.k_u;
      const auto rest =
          equilibrium_of(strategy(StrategyId::anisotropic), setting.wall, actuation, setting.stiffnesses, setting.goal);
      const Rounding rounding = underactuated_rounding(setting, tracking_ratio(setting.stiffnesses));
      const double push = glm::dot(ghost_force(actuation, rest.force, full.force), setting.wall.normal);
      EXPECT_GT(std::abs(push), 100.0 * (rounding.force + fully_actuated_rounding(setting).force));
      EXPECT_EQ(push > 0.0, belief > 1.0);
      EXPECT_GT(glm::length(proxy_drift(setting.wall, rest.proxy, setting.goal)), 100.0 * rounding.proxy);
    }
  }
  EXPECT_GT(tried, settings_per_test / 4);
}

TYPED_TEST(EquilibriumTest, AGoalOutsideTheWallIsWhereEverythingRests) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(12);
  for (int i = 0; i < settings_per_test; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Stiffnesses& k = setting.stiffnesses;
    const Actuation<D> actuation = setting.actuation();
    const Vector<D> goal = setting.wall.point + along(setting.wall, setting.goal - setting.wall.point) +
                           setting.wall.normal * random.uniform(1e-6, 0.1);
    const Coupling<D> coupling = underactuated_coupling(k.k_r, k.k_t, setting.ratio, actuation);
    for (const Equilibrium<D>& rest :
         {equilibrium_fully_actuated(setting.wall, k, goal), equilibrium_naive(setting.wall, actuation, k, goal),
          equilibrium_anisotropic(setting.wall, actuation, k, goal),
          equilibrium_with_ratio(setting.wall, actuation, k, setting.ratio, goal),
          equilibrium_by_linear_solve(setting.wall, coupling, k.k_u, k.k_c, goal)}) {
      EXPECT_EQ(rest.goal, goal);
      EXPECT_EQ(rest.proxy, goal);
      EXPECT_EQ(rest.device, goal);
      EXPECT_EQ(rest.force, Vector<D>(0.0));
      EXPECT_FALSE(rest.in_contact);
    }
  }
}

// On the wall itself nothing pushes yet: contact begins inside.
TYPED_TEST(EquilibriumTest, AGoalOnTheWallFeelsNothing) {
  constexpr glm::length_t D = TypeParam::value;
  Wall<D> wall{Vector<D>(0.0), Vector<D>(0.0)};
  wall.normal[0] = 1.0;
  const auto rest = equilibrium_fully_actuated(wall, make_stiffnesses(100.0, 1e3, 1e3, 1e5), Vector<D>(0.0));
  EXPECT_FALSE(rest.in_contact);
  EXPECT_EQ(rest.force, Vector<D>(0.0));
}

// A renderer switched off, k_r = 0, is in the range of a scene and divides nothing by zero.
TYPED_TEST(EquilibriumTest, WithoutRenderingStiffnessThereIsNoForce) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(13);
  Setting<D> setting = random_setting<D>(random);
  setting.stiffnesses.k_r = 0.0;
  for (const Strategy& entry : strategy_catalog()) {
    const auto rest = equilibrium_of(entry, setting.wall, setting.actuation(), setting.stiffnesses, setting.goal);
    EXPECT_EQ(rest.force, Vector<D>(0.0)) << entry.name;
    EXPECT_EQ(rest.device, setting.goal) << entry.name;
  }
  const auto rest = equilibrium_anisotropic(setting.wall, setting.actuation(), setting.stiffnesses, setting.goal);
  EXPECT_EQ(rest.force, Vector<D>(0.0));
  EXPECT_EQ(rest.device, setting.goal);
}

// A very stiff wall and a hard one are neighbours: a tenth of the softness, a tenth of the difference.
TYPED_TEST(EquilibriumTest, HardWallIsTheLimitOfStiffOnes) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(14);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    Setting<D> setting = random_setting<D>(random);
    Stiffnesses& k = setting.stiffnesses;
    const Actuation<D> actuation = setting.actuation();
    const auto proxy_at = [&](double k_c) {
      k.k_c = k_c;
      return equilibrium_with_ratio(setting.wall, actuation, k, setting.ratio, setting.goal).proxy;
    };
    const Vector<D> hard = proxy_at(infinity);
    // k_t S: where k_t/k_c is small beside it, the first order rules and the second is below 1 %.
    const double kappa = k.k_r / k.k_u;
    const double alpha = glm::dot(setting.wall.normal, actuation.actuated * setting.wall.normal);
    const double stiff = 100.0 * k.k_t / ((1.0 + kappa) * alpha + setting.ratio * (1.0 - alpha));
    const double stiffer = 10.0 * stiff;
    const double difference = glm::length(proxy_at(stiff) - hard);
    EXPECT_NEAR(glm::length(proxy_at(stiffer) - hard), difference / 10.0, 0.01 * difference / 10.0 + 1e-15);
    EXPECT_GT(difference, 0.0);
    EXPECT_LT(difference, 0.01 * glm::length(hard - setting.goal));
  }
}

// --- The example of docs/theory.md: motion normal to a wall at 45°, one horizontal motor -----------------------------

TEST(EquilibriumExample, HasTheseNumbers) {
  const Wall<2> wall{{0.0, 0.0}, direction_at(135.0 / 180.0 * std::numbers::pi)};
  const Actuation<2> actuation = actuated_along(Vector<2>{1.0, 0.0});
  const Stiffnesses stiffnesses = make_stiffnesses(100.0, 1000.0, 1000.0, 1e5);
  const Vector<2> goal{0.040, -0.040};
  constexpr double half_a_digit = 0.0005;  // the numbers are given to three decimals of a millimetre and of a newton

  EXPECT_NEAR(depth(wall, goal) * 1e3, 56.569, half_a_digit);
  EXPECT_DOUBLE_EQ(tracking_ratio(stiffnesses), 11.0);

  struct Row {
    StrategyId id;
    double device_x_mm;
    double force_x_N;
  };
  for (const Row& row : {Row{StrategyId::full, 3.669, -3.633}, Row{StrategyId::naive, -26.556, -6.656},
                         Row{StrategyId::anisotropic, 3.669, -3.633}}) {
    const Equilibrium<2> rest = equilibrium_of(strategy(row.id), wall, actuation, stiffnesses, goal);
    EXPECT_NEAR(rest.device.x * 1e3, row.device_x_mm, half_a_digit) << strategy(row.id).name;
    EXPECT_NEAR(rest.force.x, row.force_x_N, half_a_digit) << strategy(row.id).name;
  }

  // An underactuated device cannot push along y at all, so there the hand gets where it wants to be.
  const Equilibrium<2> naive = equilibrium_naive(wall, actuation, stiffnesses, goal);
  EXPECT_EQ(naive.force.y, 0.0);
  EXPECT_EQ(naive.device.y, goal.y);
}

// tan² = 1 + κ on a hard wall: the angle between n and the motor at which the naïve proxy slides furthest.
TEST(EquilibriumExample, NaiveDriftIsLargestAtThisAngle) {
  const Wall<2> wall{{0.0, 0.0}, {0.0, 1.0}};
  const Vector<2> goal{0.0, -0.01};
  for (const double kappa : {0.5, 3.0, 10.0}) {
    const Stiffnesses stiffnesses = make_stiffnesses(100.0, 100.0 * kappa, 500.0, infinity);
    const auto drift_at = [&](double angle) {
      const Actuation<2> actuation = actuated_along(direction_at(std::numbers::pi / 2.0 + angle));
      return glm::length(proxy_drift(wall, equilibrium_naive(wall, actuation, stiffnesses, goal).proxy, goal));
    };
    const double worst = std::atan(std::sqrt(1.0 + kappa));
    for (const double away : {-0.5, -0.1, -0.01, 0.01, 0.1, 0.5}) {
      const double angle = std::min(worst + away, std::numbers::pi / 2.0);
      EXPECT_LT(drift_at(angle), drift_at(worst)) << kappa << ' ' << away;
    }
  }
}

// (20) reads k_tn where the paper prints k_t: the force of (20) is that of (11) along the motors, for a soft wall too.
// Read as k_ta it would be lower by (1 + k_tn/k_c)/(1 + k_ta/k_c).
TEST(EquilibriumExample, SoftWallForceOfTheCureIsTheFullOneNotSlightlyLower) {
  const Wall<2> wall{{0.0, 0.0}, direction_at(135.0 / 180.0 * std::numbers::pi)};
  const Actuation<2> actuation = actuated_along(Vector<2>{1.0, 0.0});
  const Stiffnesses stiffnesses = make_stiffnesses(100.0, 1000.0, 1000.0, 2000.0);
  const Vector<2> goal{0.040, -0.040};
  const double full = equilibrium_fully_actuated(wall, stiffnesses, goal).force.x;
  const double anisotropic = equilibrium_anisotropic(wall, actuation, stiffnesses, goal).force.x;
  const double k_t_read_as_k_ta = full * (1.0 + 1000.0 / 11.0 / 2000.0) / (1.0 + 1000.0 / 2000.0);
  EXPECT_NEAR(anisotropic, full, 32.0 * epsilon * std::abs(full));  // a dozen roundings
  EXPECT_GT(std::abs(anisotropic - k_t_read_as_k_ta), 0.2 * std::abs(full));
}

}  // namespace
}  // namespace ghostforce::equilibrium_test
