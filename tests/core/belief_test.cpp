#include "core/belief.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/equilibrium.h"
#include "core/ghost_force.h"
#include "tests/core/dimensions.h"
#include "tests/core/random_setting.h"

namespace ghostforce::belief_test {
namespace {

template <glm::length_t D>
double alpha_of(const Setting<D>& setting) {
  return glm::dot(setting.wall.normal, setting.actuation().actuated * setting.wall.normal);
}

template <typename Dimension>
class BeliefInDimension : public testing::Test {};
TYPED_TEST_SUITE(BeliefInDimension, Dimensions, DimensionName);

// Of ghost force and of drift, and of the sign of both.
TYPED_TEST(BeliefInDimension, WhatAWrongBeliefCostsIsWhatTheEquilibriaSay) {
  constexpr glm::length_t D = TypeParam::value;
  Random random(21);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const Setting<D> setting = random_setting<D>(random);
    const Stiffnesses& k = setting.stiffnesses;
    const Actuation<D> actuation = setting.actuation();
    const double alpha = alpha_of(setting);
    if (alpha < 0.02 || alpha > 0.98) continue;  // there naive rendering makes no error to compare with
    const double kappa = k.k_r / k.k_u;
    if (kappa < 0.01) continue;  // nor there
    const double beta = random.over_decades(0.1, 10.0);
    const auto errors = [&](double ratio) {
      const Equilibrium<D> rest = equilibrium_with_ratio(setting.wall, actuation, k, ratio, setting.goal);
      const Equilibrium<D> full = equilibrium_fully_actuated(setting.wall, k, setting.goal);
      // Each along its own direction, so that it has a sign.
      const Vector<D> motor = glm::normalize(actuation.actuated * setting.wall.normal);
      const Vector<D> across = glm::normalize(along(setting.wall, actuation.actuated * setting.wall.normal));
      return Vector<2>(glm::dot(motor, ghost_force(actuation, rest.force, full.force)),
                       glm::dot(across, proxy_drift(setting.wall, rest.proxy, setting.goal)));
    };
    const Vector<2> naive = errors(1.0);
    const Vector<2> believed = errors(optimal_tracking_ratio(k.k_r, beta * k.k_u));
    const double told = error_of_belief(beta, alpha, kappa, k.k_t / k.k_c);
    // Differences of forces and of places of 100 mm, to some roundings of each; naive's error is a share of that.
    const Equilibrium<D> full = equilibrium_fully_actuated(setting.wall, k, setting.goal);
    const double force_rounding = 1e-14 * glm::length(full.force) / std::abs(naive.x);
    const double place_rounding = 1e-14 / std::abs(naive.y);
    if (force_rounding > 1e-6 || place_rounding > 1e-6) continue;  // too shallow to see anything
    ++compared;
    const double greatest = std::max(1.0, std::abs(told));
    EXPECT_NEAR(believed.x / naive.x, told, greatest * (100.0 * force_rounding + 1e-11));
    EXPECT_NEAR(believed.y / naive.y, told, greatest * (100.0 * place_rounding + 1e-11));
  }
  EXPECT_GT(compared, 800);
}

TEST(BeliefTest, ARightBeliefCostsNothingAndNoRenderingIsNaive) {
  Random random(22);
  for (int i = 0; i < 500; ++i) {
    const double alpha = random.uniform(0.0, 1.0);
    const double kappa = random.over_decades(0.01, 100.0);
    const double epsilon = random.once_in(3) ? 0.0 : random.over_decades(1e-4, 10.0);
    EXPECT_EQ(error_of_belief(1.0, alpha, kappa, epsilon), 0.0);
    // An infinite belief has ρ = 1.
    EXPECT_EQ(error_of_belief(std::numeric_limits<double>::infinity(), alpha, kappa, epsilon), 1.0);
    // Above the truth always better than naive; half the truth, too.
    for (const double beta : {0.5, 0.7, 0.99, 1.01, 1.5, 3.0, 100.0}) {
      EXPECT_LT(std::abs(error_of_belief(beta, alpha, kappa, epsilon)), 1.0) << beta;
      EXPECT_EQ(error_of_belief(beta, alpha, kappa, epsilon) > 0.0, beta > 1.0);
    }
    // The more is believed, the more it is like naive rendering.
    double before = -std::numeric_limits<double>::infinity();
    for (double beta = 0.05; beta < 50.0; beta *= 1.1) {
      const double error = error_of_belief(beta, alpha, kappa, epsilon);
      EXPECT_GT(error, before);
      before = error;
    }
  }
}

// ---- Least regret ---------------------------------------------------------------------------------------------------

struct Regrets {
  Wall<2> wall;
  Actuation<2> actuation;
  Stiffnesses k;

  // |f − f of the fully actuated strategy| over the latter, of one hand.
  double of(double ratio, double k_u) const {
    Stiffnesses hand = k;
    hand.k_u = k_u;
    const Vector<2> goal = -0.02 * wall.normal;
    const Vector<2> force = equilibrium_with_ratio(wall, actuation, hand, ratio, goal).force;
    const Vector<2> full = actuation.actuated * equilibrium_fully_actuated(wall, hand, goal).force;
    return glm::length(force - full) / glm::length(full);
  }
  // Of any hand of the range.
  double greatest(double ratio, const NumberRange& hands) const {
    double worst = 0.0;
    for (int i = 1; i < 20; ++i) {
      worst = std::max(worst, of(ratio, hands.least * std::pow(hands.greatest / hands.least, i / 20.0)));
    }
    return std::max({worst, of(ratio, hands.least), of(ratio, hands.greatest)});
  }
};

struct Drawn {
  double alpha;
  double k_r;
  double epsilon;
  NumberRange hands;
  Regrets regrets;
};

Drawn draw(Random& random) {
  const double angle = random.uniform(0.1, 1.45);
  Drawn drawn{.alpha = std::cos(angle) * std::cos(angle),
              .k_r = random.over_decades(20.0, 3000.0),
              .epsilon = random.once_in(3) ? 0.0 : random.over_decades(1e-4, 3.0),
              .hands = {random.over_decades(20.0, 200.0), 0.0},
              .regrets = {{{0.0, 0.0}, direction_at(angle)}, actuated_along(Vector<2>{1.0, 0.0}), {}}};
  drawn.hands.greatest = drawn.hands.least * random.over_decades(1.2, 50.0);
  const double k_t = 500.0;
  const double hard = std::numeric_limits<double>::infinity();
  drawn.regrets.k = make_stiffnesses(1.0, drawn.k_r, k_t, drawn.epsilon > 0.0 ? k_t / drawn.epsilon : hard);
  return drawn;
}

TEST(BeliefTest, TheRatioOfLeastRegretIsTheBestThatCanBeFound) {
  Random random(23);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const Drawn drawn = draw(random);
    const double ratio = least_regret_ratio(drawn.alpha, drawn.k_r, drawn.epsilon, drawn.hands);
    const double regret = drawn.regrets.greatest(ratio, drawn.hands);
    // The ends are alike, and nothing between them is worse.
    EXPECT_NEAR(drawn.regrets.of(ratio, drawn.hands.least), regret, 1e-9 * (1.0 + regret));
    EXPECT_NEAR(drawn.regrets.of(ratio, drawn.hands.greatest), regret, 1e-9 * (1.0 + regret));
    double best = std::numeric_limits<double>::infinity();
    for (double other = 1.0; other < 1.0 + drawn.k_r / drawn.hands.least; other *= 1.002) {
      best = std::min(best, drawn.regrets.greatest(other, drawn.hands));
    }
    EXPECT_LE(regret, best + 1e-12);
    // One of them is that near: a thousandth of a ratio of at most 150 changes a regret by no more than that share of a.
    EXPECT_GE(regret, best - 0.01 * (1.0 + best));
  }
}

TEST(BeliefTest, At45DegreesAndAHardWallItIsTheGeometricMean) {
  Random random(24);
  for (int i = 0; i < 200; ++i) {
    const NumberRange hands{random.over_decades(20.0, 200.0), random.over_decades(200.0, 2000.0)};
    const double k_r = random.over_decades(10.0, 5000.0);
    const double mean = std::sqrt((1.0 + k_r / hands.least) * (1.0 + k_r / hands.greatest));
    EXPECT_NEAR(least_regret_ratio(0.5, k_r, 0.0, hands) / mean, 1.0, 1e-14);
  }
}

TEST(BeliefTest, StaysBetweenTheRatiosOfTheTwoEndsForEveryAngle) {
  Random random(25);
  for (int i = 0; i < 2000; ++i) {
    const NumberRange hands{random.over_decades(20.0, 200.0), random.over_decades(200.0, 2000.0)};
    const double k_r = random.once_in(10) ? 0.0 : random.over_decades(1e-3, 1e6);
    const double alpha = random.once_in(10) ? 1.0 : random.once_in(10) ? 0.0 : random.uniform(0.0, 1.0);
    const double epsilon = random.once_in(3) ? 0.0 : random.over_decades(1e-6, 1e6);
    const double ratio = least_regret_ratio(alpha, k_r, epsilon, hands);
    SCOPED_TRACE(testing::Message() << "α " << alpha << ", k_r " << k_r << ", ε " << epsilon);
    EXPECT_GE(ratio, (1.0 + k_r / hands.greatest) * (1.0 - 1e-12));
    EXPECT_LE(ratio, (1.0 + k_r / hands.least) * (1.0 + 1e-12));
  }
  // A hand that is known exactly.
  EXPECT_NEAR(least_regret_ratio(0.3, 600.0, 0.01, {200.0, 200.0}), 4.0, 1e-13);
}

// At 45°, for the rendering that is usual: 40 to 51 % instead of 75 to 89 %.
TEST(BeliefTest, TheWorstErrorOfUsualHandsIsHalfThatOfNaiveRendering) {
  Regrets regrets{{{0.0, 0.0}, direction_at(std::numbers::pi / 4.0)}, actuated_along(Vector<2>{1.0, 0.0}), {}};
  for (const double k_r : {300.0, 600.0, 800.0}) {
    regrets.k = make_stiffnesses(1.0, k_r, k_r, std::numeric_limits<double>::infinity());
    const double ratio = least_regret_ratio(0.5, k_r, 0.0, usual_hands);
    EXPECT_NEAR(regrets.greatest(ratio, usual_hands), 0.455, 0.06) << k_r;
    EXPECT_NEAR(regrets.greatest(1.0, usual_hands), 0.82, 0.075) << k_r;
  }
}

TEST(BeliefTest, TheBeliefOfLeastRegretHasThatRatio) {
  Random random(26);
  for (int i = 0; i < 500; ++i) {
    Settings settings;
    settings.wall_normal_angle = random.uniform(-3.0, 3.0);
    settings.actuated_angle = random.uniform(-3.0, 3.0);
    settings.stiffnesses = make_stiffnesses(200.0, random.over_decades(50.0, 5000.0), random.over_decades(50.0, 5000.0),
                                            random.once_in(4) ? 1e300 : random.over_decades(100.0, 1e6));
    const double along_motor = std::cos(settings.wall_normal_angle - settings.actuated_angle);
    const double ratio = least_regret_ratio(along_motor * along_motor, settings.stiffnesses.k_r,
                                            settings.stiffnesses.k_t / settings.stiffnesses.k_c, usual_hands);
    const double belief = least_regret_belief(settings);
    EXPECT_GE(belief, usual_hands.least);
    EXPECT_LE(belief, usual_hands.greatest);
    // ρ − 1 is 1/20 or more, so that nothing cancels; the two angles round the cosine.
    EXPECT_NEAR(optimal_tracking_ratio(settings.stiffnesses.k_r, belief) / ratio, 1.0, 1e-12);
  }
  Settings forceless;
  forceless.stiffnesses = make_stiffnesses(200.0, 0.0, 600.0, 1e5);
  EXPECT_TRUE(least_regret_belief(forceless) >= usual_hands.least &&
              least_regret_belief(forceless) <= usual_hands.greatest);
}

}  // namespace
}  // namespace ghostforce::belief_test
