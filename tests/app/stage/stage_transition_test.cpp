// Switching is seen, not cut: what is shown on the way is true of some device, and nothing jumps.
#include "app/stage/stage_transition.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "core/prediction.h"
#include "core/simulate.h"

namespace ghostforce::stage_transition_test {
namespace {

constexpr double frame_s = 1.0 / 60.0;

Snapshot snapshot_at_rest(const Settings& settings, const Vector<2>& goal) {
  Snapshot snapshot;
  snapshot.goal = goal;
  const auto equilibria = predicted_equilibria(settings, goal);
  for (std::size_t i = 0; i < strategy_count; ++i) {
    snapshot.strategies[i] = {.device = equilibria[i].at.device,
                              .proxy = equilibria[i].at.proxy,
                              .contact = equilibria[i].at.contact,
                              .force = equilibria[i].at.force,
                              .ghost_force = equilibria[i].ghost_force,
                              .proxy_drift = equilibria[i].proxy_drift,
                              .in_contact = equilibria[i].at.in_contact};
  }
  return snapshot;
}

struct Way {
  Settings settings = load_scene("wall45").settings;
  Vector<2> goal = load_scene("wall45").goal.points.back();
  Snapshot snapshot = snapshot_at_rest(settings, goal);

  StageMoment at(const StageBlend& blend, StrategyId active) {
    settings.active = active;
    return stage_moment_between(settings, snapshot, goal, blend);
  }
};

TEST(StageTransition, PicturesBetweenNaiveAndAnisotropicAreRestsAtARatioBetween) {
  Way way;
  double before = 0.0;
  for (const double cure : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const double ratio = tracking_ratio_at(way.settings, cure);
    EXPECT_GT(ratio, std::max(1.0, before));
    EXPECT_LT(ratio, tracking_ratio(way.settings.stiffnesses));
    before = ratio;
    const StageMoment shown = way.at({.fullness = 0.0, .cure = cure}, StrategyId::anisotropic);
    const Equilibrium<2> rest = equilibrium_with_ratio(wall_of(way.settings), actuation_of(way.settings),
                                                       way.settings.stiffnesses, ratio, way.goal);
    EXPECT_LT(glm::distance(shown.handle, rest.device), 1e-14);
    EXPECT_LT(glm::distance(shown.proxy, rest.proxy), 1e-14);
    EXPECT_LT(glm::distance(shown.wall_share + shown.ghost_force, rest.force), 1e-12);
    EXPECT_TRUE(shown.is_between());
  }
}

TEST(StageTransition, BothEndsAreWhatTheSimulationHas) {
  // While everything moves, not at rest.
  const Scene scene = load_scene("wall45");
  Snapshot moving;
  simulate(scene, 700, [&](const Snapshot& snapshot) { moving = snapshot; });
  for (const Strategy& entry : strategy_catalog()) {
    Settings settings = scene.settings;
    settings.active = entry.id;
    const StageMoment shown = stage_moment_between(settings, moving, moving.goal, stage_blend_of(entry.id));
    const StrategySnapshot<2>& now = moving.strategies[index_of(entry.id)];
    EXPECT_EQ(shown.handle, now.device);
    EXPECT_EQ(shown.proxy, now.proxy);
    EXPECT_EQ(shown.ghost_force, now.ghost_force);
    EXPECT_EQ(shown.slide, now.proxy_drift);
    EXPECT_FALSE(shown.is_between());
  }
  // And close to an end, close to it.
  Settings settings = scene.settings;
  settings.active = StrategyId::anisotropic;
  const StageMoment late = stage_moment_between(settings, moving, moving.goal, {.fullness = 0.0, .cure = 1.0 - 1e-9});
  EXPECT_LT(glm::distance(late.handle, moving.strategies[index_of(StrategyId::anisotropic)].device), 1e-9);
}

TEST(StageTransition, ToAndFromEveryMotorItIsAStraightLine) {
  Way way;
  const Vector<2> naive = way.snapshot.strategies[index_of(StrategyId::naive)].device;
  const Vector<2> full = way.snapshot.strategies[index_of(StrategyId::full)].device;
  for (const double fullness : {0.25, 0.5, 0.75}) {
    const StageMoment shown = way.at({.fullness = fullness, .cure = 0.0}, StrategyId::full);
    EXPECT_LT(glm::distance(shown.handle, naive + fullness * (full - naive)), 1e-14);
  }
}

// With one motor there are two strategies. On the way to every motor the stage does not pass through the other one.
TEST(StageTransition, ToAndFromEveryMotorTheStrategyOfOneMotorStays) {
  for (const StrategyId of_one_motor : {StrategyId::naive, StrategyId::anisotropic}) {
    const double cure = stage_blend_of(of_one_motor).cure;
    StageTransition transition(of_one_motor);
    for (const StrategyId next : {StrategyId::full, of_one_motor}) {
      transition.go_to(next, false);
      transition.advance(0.5 * StageTransition::usual_s);
      EXPECT_GT(transition.blend().fullness, 0.0);
      EXPECT_LT(transition.blend().fullness, 1.0);
      EXPECT_EQ(transition.blend().cure, cure);
      transition.advance(StageTransition::usual_s);
    }
  }
}

TEST(StageTransition, NothingJumpsInAFrameHoweverOftenOneSwitches) {
  Way way;
  std::mt19937 random(7);
  StageTransition transition(StrategyId::naive);
  StrategyId active = StrategyId::naive;
  StageMoment before = way.at(transition.blend(), active);
  const auto equilibria = predicted_equilibria(way.settings, way.goal);
  double longest = 0.0;  // way between any two rests
  for (const auto& one : equilibria) {
    for (const auto& other : equilibria) longest = std::max(longest, glm::distance(one.at.device, other.at.device));
  }
  // The smooth step is at most half as fast again as an even one, and the rests over log ρ at most twice.
  const double most = 3.0 * longest * frame_s / StageTransition::usual_s;
  for (int frame = 0; frame < 3000; ++frame) {
    if (random() % 20 == 0) active = strategy_catalog()[random() % strategy_count].id;
    transition.advance(frame_s);
    transition.go_to(active, false);
    const StageMoment now = way.at(transition.blend(), active);
    EXPECT_LE(glm::distance(now.handle, before.handle), most) << frame;
    EXPECT_LE(
        std::abs(signed_ghost_force(now) - signed_ghost_force(before)),
        3.0 * glm::length(equilibria[index_of(StrategyId::naive)].ghost_force) * frame_s / StageTransition::usual_s)
        << frame;
    before = now;
  }
}

TEST(StageTransition, TakesAsLongAsItShould) {
  for (const bool slowly : {false, true}) {
    StageTransition transition(StrategyId::naive);
    transition.go_to(StrategyId::anisotropic, slowly);
    const double lasts_s = slowly ? 6.0 : 0.6;
    transition.advance(0.99 * lasts_s);
    EXPECT_TRUE(transition.is_running());
    transition.advance(0.02 * lasts_s);
    EXPECT_FALSE(transition.is_running());
    EXPECT_EQ(transition.blend(), stage_blend_of(StrategyId::anisotropic));
  }
}

TEST(StageTransition, WithADeviceInTheHandNothingIsBetween) {
  Way way;
  way.snapshot.measured = StrategyId::anisotropic;
  const StageMoment shown = way.at({.fullness = 0.0, .cure = 0.5}, StrategyId::anisotropic);
  EXPECT_FALSE(shown.is_between());
  EXPECT_EQ(shown.handle, way.snapshot.strategies[index_of(StrategyId::anisotropic)].device);
}

TEST(StageMoment, WhereItShouldRestIsTheAnisotropicRestAtTheTrueRatio) {
  Way way;
  way.settings.stiffnesses.believed_k_u = 50.0;  // a wrong belief moves the handle, not where it should be
  const Equilibrium<2> right =
      equilibrium_anisotropic(wall_of(way.settings), actuation_of(way.settings), way.settings.stiffnesses, way.goal);
  for (const StrategyId id : {StrategyId::naive, StrategyId::anisotropic}) {
    const StageMoment shown = way.at(stage_blend_of(id), id);
    EXPECT_LT(glm::distance(shown.expected_rest, right.device), 1e-12);
  }
  const StageMoment full = way.at(stage_blend_of(StrategyId::full), StrategyId::full);
  EXPECT_EQ(full.expected_rest, way.snapshot.strategies[index_of(StrategyId::full)].device);
}

}  // namespace
}  // namespace ghostforce::stage_transition_test
