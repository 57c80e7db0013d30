#include "core/general_tick.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/divergence.h"
#include "core/general_equilibrium.h"
#include "tests/core/general_scenes.h"
#include "tests/core/random_setting.h"
#include "tests/support/heap_guard.h"

namespace ghostforce::general_tick_test {
namespace {

static_assert(std::is_trivially_copyable_v<GeneralCoefficients>);
static_assert(std::is_trivially_copyable_v<LoopCoefficients>);
static_assert(noexcept(general_coefficients_of(std::declval<const Settings&>())));
static_assert(noexcept(tick(std::declval<const GeneralCoefficients&>(), std::declval<const Vector<2>&>(),
                            std::declval<TickState<2>&>())));

Settings paper_settings(double wall_deg, double motor_deg) {
  Settings settings = common_general_settings();
  settings.wall_normal_angle = wall_deg / degrees_per_radian;
  settings.actuated_angle = motor_deg / degrees_per_radian;
  return settings;
}

TickState<2> state_after(const GeneralCoefficients& coefficients, const Vector<2>& start, const Vector<2>& goal,
                         int ticks) {
  TickState<2> state = state_at_start(start);
  for (int k = 1; k <= ticks; ++k) {
    // In one second, as the scenes' hands do.
    tick(coefficients, glm::mix(start, goal, std::min(1.0, k / coefficients.rate)), state);
  }
  return state;
}

// Given the paper's parameters, one tick of the general loop from the same state makes the same proxy and device, and a
// force that differs by k_r dt P_A v, the paper's proxy being one tick old.
TEST(GeneralTick, DiffersFromThePapersTickByWhatItsOldProxyMakes) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    Settings settings = paper_settings(random.uniform(0.0, 360.0), random.uniform(0.0, 360.0));
    settings.stiffnesses.k_c = random.once_in(3) ? no_limit : 1e5;
    const TickCoefficients<2> paper = coefficients_of(settings);
    const GeneralCoefficients general = general_coefficients_of(settings);
    const Matrix<2> actuated = actuation_of(settings).actuated;
    TickState<2> state = state_at_start(Vector<2>(0.0));
    for (int k = 0; k < 400; ++k) {
      TickState<2> other = state;
      const Snapshot before = snapshot_of(paper, state);
      // What the paper's loop holds is what the general one is told to hold.
      for (std::size_t i = 0; i < strategy_count; ++i) other.strategies[i].force = before.strategies[i].force;
      const Vector<2> goal = -1e-4 * k * wall_of(settings).normal + Vector<2>(0.01 * std::sin(0.02 * k), 0.0);
      tick(paper, goal, state);
      tick(general, goal, other);
      const Snapshot now = snapshot_of(paper, state);
      for (const Strategy& each : strategy_catalog()) {
        const std::size_t i = index_of(each.id);
        const auto& mine = other.strategies[i];
        EXPECT_LT(glm::length(mine.motion.position - state.strategies[i].motion.position), 1e-16);
        EXPECT_LT(glm::length(mine.proxy - state.strategies[i].proxy), 1e-15);
        EXPECT_EQ(mine.in_contact, state.strategies[i].in_contact);
        const Vector<2> velocity = state.strategies[i].motion.velocity;
        const Vector<2> artefact =
            settings.stiffnesses.k_r / settings.rate * (each.has_every_motor ? velocity : actuated * velocity);
        EXPECT_LT(glm::length(now.strategies[i].force - (mine.force - artefact)), 1e-11) << seed << " " << k;
      }
    }
  }
}

TEST(GeneralTick, RestsWhereThePapersLoopRests) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    Settings settings = paper_settings(random.uniform(0.0, 360.0), random.uniform(0.0, 360.0));
    settings.stiffnesses.k_c = random.once_in(3) ? no_limit : 1e5;
    if (random.once_in(3)) settings.stiffnesses.believed_k_u = random.uniform(100.0, 400.0);
    const TickCoefficients<2> paper = coefficients_of(settings);
    const GeneralCoefficients general = general_coefficients_of(settings);
    const Wall<2> wall = wall_of(settings);
    const Vector<2> goal = -0.02 * wall.normal;
    TickState<2> mine = state_at_start(-goal);
    TickState<2> papers = mine;
    for (int k = 0; k < 6000; ++k) {
      tick(general, goal, mine);
      tick(paper, goal, papers);
    }
    const Snapshot expected = snapshot_of(paper, papers);
    Snapshot shown;
    take_snapshot(general, mine, shown);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      EXPECT_LT(glm::length(mine.strategies[i].motion.position - expected.strategies[i].device), 1e-12);
      EXPECT_LT(glm::length(mine.strategies[i].proxy - expected.strategies[i].proxy), 1e-12);
      EXPECT_LT(glm::length(mine.strategies[i].force - expected.strategies[i].force), 1e-12 * 600.0);
      EXPECT_LT(glm::length(shown.strategies[i].ghost_force - expected.strategies[i].ghost_force), 1e-12 * 600.0);
      // Of a soft wall another force is another depth of the proxy, too, which the paper's drift leaves out.
      const Vector<2> slide = shown.strategies[i].proxy_drift;
      const Vector<2> along = slide - wall.normal * glm::dot(wall.normal, slide);
      EXPECT_LT(glm::length(along - expected.strategies[i].proxy_drift), 1e-12);
      EXPECT_TRUE(settings.stiffnesses.k_c < no_limit || glm::length(slide - along) < 1e-12);
    }
  }
}

TEST(GeneralTick, ShippedScenesComeToTheRestThatIsPredicted) {
  for (Settings (*settings)() : {arm_settings, pantograph_settings, string_settings, corner_settings, curve_settings}) {
    const GeneralCoefficients coefficients = general_coefficients_of(settings());
    const bool is_ring = is_curved(coefficients.scene.constraint);
    const Vector<2> goal = is_ring ? Vector<2>(0.034, -0.034) : Vector<2>(0.004, -0.016);
    const Vector<2> start = is_ring ? Vector<2>(0.01, -0.005) : Vector<2>(-0.006, 0.024);
    const TickState<2> state = state_after(coefficients, start, goal, 4000);
    const auto predicted = predicted_general_equilibria(coefficients.scene, goal);
    Snapshot snapshot;
    take_snapshot(coefficients, state, snapshot);
    for (std::size_t i = 0; i < strategy_count; ++i) {
      ASSERT_TRUE(predicted[i]);
      EXPECT_LT(glm::length(snapshot.strategies[i].device - predicted[i]->rest.at.device), 1e-12);
      EXPECT_LT(glm::length(snapshot.strategies[i].proxy - predicted[i]->rest.at.proxy), 1e-12);
      EXPECT_LT(glm::length(snapshot.strategies[i].force - predicted[i]->rest.at.force), 1e-9);
      EXPECT_LT(glm::length(snapshot.strategies[i].ghost_force - predicted[i]->ghost_force), 1e-9);
      EXPECT_LT(glm::length(snapshot.strategies[i].proxy_drift - predicted[i]->slide), 1e-12);
      EXPECT_EQ(state.strategies[i].contact.active, predicted[i]->rest.active);
      for (std::size_t motor = 0; motor < most_motors; ++motor) {
        EXPECT_NEAR(state.strategies[i].contact.efforts[motor], predicted[i]->rest.efforts[motor], 1e-9);
      }
    }
  }
}

// κ_w < 1 + b̄/dt: with a hard wall straight across a motor, k_r < k_u + b/dt = 5.2 kN/m, whatever the mass.
TEST(GeneralTick, IsStableUpToTheBoundOfTheoryAndNotBeyond) {
  for (const double mass : {0.02, 0.1, 0.5}) {
    for (const double k_r : {5100.0, 5300.0}) {
      Settings settings = paper_settings(180.0, 0.0);
      settings.mass = mass;
      settings.stiffnesses.k_r = settings.stiffnesses.k_t = k_r;
      settings.stiffnesses.k_c = no_limit;
      const GeneralCoefficients coefficients = general_coefficients_of(settings);
      const Vector<2> goal(0.02, 0.0);
      const auto rest = general_equilibrium_of(StrategyId::full, coefficients.scene, goal);
      TickState<2> state = state_at_start(goal);
      for (auto& own : state.strategies) {
        own.motion.position = rest->at.device + Vector<2>(1e-9, 0.0);  // so little that the wall is never left
        own.proxy = rest->at.proxy;
        own.force = rest->at.force;
      }
      const auto widest_swing = [&] {
        double widest = 0.0;
        for (int k = 0; k < 1000; ++k) {
          tick(coefficients, goal, state);
          for (const auto& own : state.strategies) {
            widest = std::max(widest, glm::length(own.motion.position - rest->at.device));
          }
        }
        return widest;
      };
      const double early = widest_swing();
      for (int k = 0; k < 5000; ++k) tick(coefficients, goal, state);
      EXPECT_EQ(widest_swing() < early, k_r < 5200.0) << mass;
    }
  }
}

TEST(GeneralTick, NothingActsInFreeSpace) {
  Settings settings = arm_settings();
  const GeneralCoefficients coefficients = general_coefficients_of(settings);
  TickState<2> state = state_at_start(Vector<2>(-0.03, 0.03));
  for (int k = 0; k < 100; ++k) {
    tick(coefficients, Vector<2>(-0.03 + 1e-4 * k, 0.03), state);
    for (const auto& own : state.strategies) {
      EXPECT_EQ(own.force, Vector<2>(0.0));
      EXPECT_EQ(own.contact.status, ContactStatus::free);
      EXPECT_EQ(own.energy, 0.0);
    }
  }
}

TEST(GeneralTick, OutsideTheWorkspaceThereIsNoEffort) {
  const GeneralCoefficients coefficients = general_coefficients_of(arm_settings());
  TickState<2> state = state_at_start(Vector<2>(0.4, -0.4));
  tick(coefficients, Vector<2>(0.4, -0.4), state);
  for (const auto& own : state.strategies) {
    EXPECT_EQ(own.contact.status, ContactStatus::outside_workspace);
    EXPECT_EQ(own.force, Vector<2>(0.0));
    EXPECT_EQ(own.contact.efforts, Efforts{});
    EXPECT_FALSE(own.in_contact);
  }
}

// Naïve rendering on an arm whose sum is negative at the wall: no rest, and the handle runs away from the other two.
TEST(GeneralTick, WithoutARestTheNaiveHandleRunsAway) {
  int without = 0;
  int settled = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    Settings settings = arm_settings();
    settings.general.arm.base = 0.2 * direction_at(random.uniform(0.0, 6.3));
    settings.general.arm.motor = random.once_in(2) ? TwoLinkArm::Motor::base : TwoLinkArm::Motor::elbow;
    settings.wall_normal_angle = random.uniform(0.0, 6.3);
    settings.stiffnesses.k_r = settings.stiffnesses.k_t = 2000.0;
    const GeneralCoefficients coefficients = general_coefficients_of(settings);
    const Vector<2> goal = -0.01 * wall_of(settings).normal;
    const auto rest = general_equilibrium_of(StrategyId::naive, coefficients.scene, goal);
    const TickState<2> state = state_after(coefficients, -goal, goal, 6000);
    const auto& naive = state.strategies[index_of(StrategyId::naive)];
    const double balance = glm::length(coefficients.user_stiffness * (goal - naive.motion.position) + naive.force);
    const bool stands =
        glm::length(naive.motion.velocity) < 1e-7 && balance < 1e-5 && naive.contact.status == ContactStatus::contact;
    if (!rest) {
      ++without;
      EXPECT_FALSE(stands) << seed;
    } else if (stands) {
      ++settled;
      EXPECT_LT(glm::length(naive.motion.position - rest->at.device), 1e-6) << seed;
    }
    for (const StrategyId id : {StrategyId::full, StrategyId::anisotropic}) {
      const auto other = general_equilibrium_of(id, coefficients.scene, goal);
      ASSERT_TRUE(other) << seed;
      EXPECT_LT(glm::length(state.strategies[index_of(id)].motion.position - other->at.device), 1e-9) << seed;
    }
  }
  EXPECT_GT(without, 5);
  EXPECT_GT(settled, 100);
}

TEST(GeneralTick, AllocatesNothing) {
  for (Settings (*settings)() : {arm_settings, pantograph_settings, string_settings, corner_settings, curve_settings}) {
    const GeneralCoefficients coefficients = general_coefficients_of(settings());
    TickState<2> state = state_at_start(Vector<2>(0.0));
    Snapshot snapshot;
    const HeapGuard guard;
    for (int k = 0; k < 200; ++k) {
      tick(coefficients, Vector<2>(3e-4, -2e-4) * static_cast<double>(k), state);
      take_snapshot(coefficients, state, snapshot);
    }
    predicted_general_equilibria(coefficients.scene, Vector<2>(0.03, -0.02));
  }
}

}  // namespace
}  // namespace ghostforce::general_tick_test
