#include "core/workspace_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/general_equilibrium.h"
#include "core/scene_shape.h"
#include "tests/core/general_scenes.h"
#include "tests/core/random_setting.h"

namespace ghostforce::workspace_map_test {
namespace {

static_assert(std::is_trivially_copyable_v<WallAtPose>);
static_assert(noexcept(wall_at_pose(std::declval<const GeneralScene&>(), StrategyId::naive,
                                    std::declval<const Vector<2>&>(), std::declval<const Vector<2>&>(), 0.01)));

Settings random_device(Random& random) {
  Settings settings = random.once_in(2) ? arm_settings() : pantograph_settings();
  settings.stiffnesses.k_u = random.uniform(50.0, 400.0);
  settings.stiffnesses.k_r = random.uniform(100.0, 800.0);
  settings.stiffnesses.k_t = random.uniform(100.0, 800.0);
  settings.stiffnesses.k_c = random.once_in(2) ? no_limit : 1e5;
  if (random.once_in(2)) {
    settings.general.k_u_second = random.uniform(50.0, 400.0);
    settings.general.k_u_first_angle = random.uniform(0.0, 3.14);
  }
  if (random.once_in(2)) settings = with_other_motor(settings);
  return settings;
}

// What the hand would have to be for the handle to rest there, and the wall that pushes it.
struct Rest {
  Planes<2> wall;
  Vector<2> goal;
  double depth;
};
std::optional<Rest> rest_at(const GeneralScene& scene, StrategyId id, const Vector<2>& handle, const Vector<2>& normal,
                            double pushed_by) {
  Rest rest{{}, handle, 0.0};
  rest.wall.walls[0] = {handle + normal * pushed_by, normal};
  rest.wall.count = 1;
  const auto actuation = actuation_at(scene.mechanism, handle);
  if (!actuation) return std::nullopt;
  const double share = scene.strategies[index_of(id)].share;
  rest.goal -= scene.user_compliance * solve_contact(handle, rest.wall, *actuation, scene.compliances, share).force;
  rest.depth = -signed_distance(rest.wall.walls[0], rest.goal);
  return rest;
}

// How far from the rest a handle is in the end that began so far beside it, moved by nothing but the balance of forces.
double distance_after_drift(const GeneralScene& scene, StrategyId id, const Rest& rest, const Vector<2>& handle,
                            const Vector<2>& beside) {
  Vector<2> place = handle + beside;
  const double share = scene.strategies[index_of(id)].share;
  const double first = glm::length(beside);
  for (int i = 0; i < 5000; ++i) {
    const auto actuation = actuation_at(scene.mechanism, place);
    const double now = glm::distance(place, handle);
    if (!actuation || now > 100.0 * first || now < 0.05 * first) break;
    const Contact<2> contact = solve_contact(place, rest.wall, *actuation, scene.compliances, share);
    place += 0.02 * (rest.goal + scene.user_compliance * contact.force - place);
  }
  return glm::distance(place, handle);
}

TEST(WorkspaceMap, SharesAreThoseOfTheEquilibrium) {
  Random random(3);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    Settings settings = random_device(random);
    settings.wall_normal_angle = random.uniform(0.0, 6.28);
    const GeneralScene scene = general_scene_of(settings);
    const Vector<2> normal = direction_at(settings.wall_normal_angle);
    const Vector<2> goal = -normal * random.uniform(0.002, 0.02);
    const auto full = general_equilibrium_of(StrategyId::full, scene, goal);
    const StrategyId id = random.once_in(2) ? StrategyId::naive : StrategyId::anisotropic;
    const auto rest = general_equilibrium_of(id, scene, goal);
    if (!full || !rest) continue;
    const double depth = -signed_distance(scene.constraint, goal);
    const WallAtPose found = wall_at_pose(scene, id, rest->at.device, normal, depth);
    const double expected = glm::length(with_cost(scene, id, *rest, *full).ghost_force) / glm::length(full->at.force);
    EXPECT_NEAR(found.ghost_share, expected, 1e-6 * (1.0 + expected)) << i;
    EXPECT_EQ(found.rest, WallAtPose::Rest::stays) << i;
    ++compared;
  }
  EXPECT_GT(compared, 1500);
}

TEST(WorkspaceMap, TellsWhereTheHandleWouldRunAway) {
  Random random(4);
  int stays = 0;
  int runs_away = 0;
  for (int i = 0; i < 800; ++i) {
    Settings settings = random_device(random);
    settings.stiffnesses.k_u *= 0.4;  // so soft a hand is often dragged away
    const GeneralScene scene = general_scene_of(settings);
    const Vector<2> handle = random.in_box<2>(0.08);
    const Vector<2> normal = direction_at(random.uniform(0.0, 6.28));
    const auto rest = rest_at(scene, StrategyId::naive, handle, normal, random.uniform(0.0005, 0.01));
    if (!rest) {
      EXPECT_EQ(wall_at_pose(scene, StrategyId::naive, handle, normal, 0.01).rest, WallAtPose::Rest::unreachable);
      continue;
    }
    if (rest->depth < 1e-4) continue;
    const WallAtPose found = wall_at_pose(scene, StrategyId::naive, handle, normal, rest->depth);
    constexpr double beside = 1e-5;
    double farthest = 0.0;
    for (const double angle : {0.3, 1.9, 3.4, 5.0}) {
      const Vector<2> start = beside * direction_at(angle);
      farthest = std::max(farthest, distance_after_drift(scene, StrategyId::naive, *rest, handle, start));
    }
    if (farthest < 0.1 * beside) {
      EXPECT_EQ(found.rest, WallAtPose::Rest::stays) << i;
      ++stays;
    } else if (farthest > 10.0 * beside) {
      EXPECT_EQ(found.rest, WallAtPose::Rest::runs_away) << i;
      ++runs_away;
    }
  }
  EXPECT_GT(stays, 200);
  EXPECT_GT(runs_away, 10);
}

TEST(WorkspaceMap, TheCureRestsEverywhereWithoutAGhostForce) {
  Random random(5);
  int looked_at = 0;
  for (int i = 0; i < 2000; ++i) {
    const GeneralScene scene = general_scene_of(random_device(random));
    const WallAtPose found = wall_at_pose(scene, StrategyId::anisotropic, random.in_box<2>(0.1),
                                          direction_at(random.uniform(0.0, 6.28)), 0.01);
    if (found.rest == WallAtPose::Rest::unreachable) continue;
    EXPECT_LT(found.ghost_share, 1e-9) << i;
    EXPECT_NEAR(glm::length(found.motor), 1.0, 1e-12) << i;
    ++looked_at;
  }
  EXPECT_GT(looked_at, 500);
}

TEST(WorkspaceMap, DepthChangesNoShare) {
  const GeneralScene scene = general_scene_of(arm_settings());
  const Vector<2> normal = direction_at(2.0);
  const double share = wall_at_pose(scene, StrategyId::naive, {0.0, 0.0}, normal, 0.001).ghost_share;
  EXPECT_GT(share, 0.01);
  EXPECT_NEAR(wall_at_pose(scene, StrategyId::naive, {0.0, 0.0}, normal, 0.02).ghost_share, share, 1e-9);
}

}  // namespace
}  // namespace ghostforce::workspace_map_test
