#include "core/round_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/general_equilibrium.h"
#include "tests/core/general_scenes.h"
#include "tests/core/random_setting.h"

namespace ghostforce::round_contact_test {
namespace {

static_assert(noexcept(contact_at(std::declval<const GeneralScene&>(), std::declval<const GeneralStrategy&>(),
                                  std::declval<const Vector<2>&>(), std::declval<const Vector<2>&>())));

Settings random_round_settings(Random& random) {
  Settings settings = curve_settings();
  settings.stiffnesses.k_u = random.over_decades(20.0, 2000.0);
  settings.stiffnesses.k_r = random.over_decades(30.0, 6000.0);
  settings.stiffnesses.k_t = settings.stiffnesses.k_r * random.over_decades(0.4, 2.5);
  settings.stiffnesses.k_c = no_limit;
  settings.actuated_angle = random.uniform(0.0, 6.28);
  settings.general.k_u_second = random.over_decades(20.0, 2000.0);
  settings.general.k_u_first_angle = random.uniform(0.0, 3.14);
  settings.general.circle_center = random.in_box<2>(0.1);
  settings.general.circle_radius = random.over_decades(0.01, 0.1);
  return settings;
}

// Where the edge is nearest to q in a metric, by looking everywhere.
double least_square_distance(const RoundWall& wall, const Vector<2>& q, const Matrix<2>& metric) {
  const auto square = [&](double angle) {
    const Vector<2> way = wall.center + wall.radius * direction_at(angle) - q;
    return glm::dot(way, metric * way);
  };
  constexpr int looks = 2000;
  constexpr double look = 6.283185307179586 / looks;
  double best = 0.0;
  for (int i = 1; i < looks; ++i) best = square(look * i) < square(best) ? look * i : best;
  double from = best - look;
  double to = best + look;
  for (int i = 0; i < 60; ++i) {
    const double third = (to - from) / 3.0;
    (square(from + third) < square(to - third) ? to : from) +=
        square(from + third) < square(to - third) ? -third : third;
  }
  return square(0.5 * (from + to));
}

// However deep the handle is, and wherever the proxy was.
TEST(RoundContact, InsideARingTheProxyIsTheNearestPointInTheMetricOfTracking) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    const Settings settings = random_round_settings(random);
    const GeneralScene scene = general_scene_of(settings);
    const RoundWall wall = std::get<RoundWall>(scene.constraint);
    const Vector<2> q =
        wall.center + wall.radius * random.over_decades(1.001, 20.0) * direction_at(random.uniform(0.0, 6.28));
    const ActuationMatrix<2> actuation = *actuation_at(scene.mechanism, q);
    const Matrix<2> projector = actuated_projection(actuation, all_motors(1), scene.compliances.user).projector;
    for (const Strategy& each : strategy_catalog()) {
      const GeneralStrategy& own = scene.strategies[index_of(each.id)];
      const Matrix<2> metric =
          glm::inverse(tracking_compliance(scene.compliances, projector, own.has_every_motor ? 0.0 : own.share));
      const Contact<2> contact = contact_at(scene, own, q, wall.center + direction_at(random.uniform(0.0, 6.28)));
      ASSERT_EQ(contact.status, ContactStatus::contact) << seed;
      const Vector<2> way = contact.proxy - q;
      EXPECT_NEAR(glm::dot(way, metric * way) / least_square_distance(wall, q, metric), 1.0, 1e-12) << seed;
      EXPECT_NEAR(glm::length(contact.proxy - wall.center), wall.radius, 1e-13) << seed;
      const Contact<2> again = contact_at(scene, own, q, contact.proxy);
      EXPECT_LT(glm::length(again.proxy - contact.proxy), 1e-13 * glm::length(q - wall.center) / wall.radius) << seed;
    }
  }
}

// Strings have no metric: their proxy is told by the push, which is along the foot it lies on.
TEST(RoundContact, WithStringsTheProxyLiesOnItsOwnFoot) {
  int slack = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Random random(seed);
    Settings settings = random_round_settings(random);
    settings.stiffnesses.k_c = random.once_in(2) ? no_limit : random.over_decades(1e3, 1e6);
    settings.general.circle_is_free_inside = !random.once_in(3);
    settings.general.mechanism = MechanismKind::strings;
    settings.general.strings.count = static_cast<std::uint32_t>(1 + random.below(4));
    for (Vector<2>& anchor : settings.general.strings.anchors) anchor = 2.0 * direction_at(random.uniform(0.0, 6.28));
    if (random.once_in(3)) settings.general.strings.most = random.uniform(0.3, 2.0);
    const GeneralScene scene = general_scene_of(settings);
    const RoundWall wall = std::get<RoundWall>(scene.constraint);
    const double deep = wall.is_free_inside ? random.over_decades(1.001, 10.0) : random.uniform(0.05, 0.99);
    const Vector<2> q = wall.center + wall.radius * deep * direction_at(random.uniform(0.0, 6.28));
    const GeneralStrategy& own = scene.strategies[index_of(StrategyId::anisotropic)];
    const Contact<2> contact = contact_at(scene, own, q, wall.center + 0.01 * direction_at(random.uniform(0.0, 6.28)));
    ASSERT_EQ(contact.status, ContactStatus::contact) << seed;
    const Vector<2> inwards = outwards(wall, contact.proxy) * (wall.is_free_inside ? -1.0 : 1.0);
    const double push = glm::length(contact.contact_force);
    EXPECT_LT(glm::length(contact.contact_force - push * inwards), 1e-10 * push) << seed;
    slack += contact.efforts[0] == 0.0 ? 1 : 0;
  }
  EXPECT_GT(slack, 50);
}

// Once a tick, a tangent plane at the last proxy would send the proxy of a handle that is deeper than two radii from
// the centre to and fro for ever.
TEST(RoundContact, TheLoopRestsHoweverDeepTheHandleIsInARing) {
  for (const double depth_mm : {60.0, 70.5, 80.0, 90.0, 300.0}) {
    const GeneralCoefficients coefficients = general_coefficients_of(curve_settings());
    const Vector<2> start(0.007, -0.007);
    const Vector<2> goal(0.0005, -1e-3 * depth_mm);
    TickState<2> state = state_at_start(start);
    for (int k = 1; k <= 6000; ++k) tick(coefficients, glm::mix(start, goal, std::min(1.0, k / 1000.0)), state);
    const TickState<2> before = state;
    tick(coefficients, goal, state);
    for (const Strategy& each : strategy_catalog()) {
      const auto rest = general_equilibrium_of(each.id, coefficients.scene, goal);
      const auto& own = state.strategies[index_of(each.id)];
      ASSERT_TRUE(rest);
      EXPECT_LT(glm::length(own.motion.position - rest->at.device), 1e-10) << each.name << " " << depth_mm;
      EXPECT_LT(glm::length(own.force - rest->at.force), 1e-8) << each.name << " " << depth_mm;
      EXPECT_LT(glm::length(own.force - before.strategies[index_of(each.id)].force), 1e-9) << each.name;
    }
  }
}

}  // namespace
}  // namespace ghostforce::round_contact_test
