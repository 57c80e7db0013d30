// The batch against the tick, lane by lane.
#include "core/batch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/tick.h"
#include "tests/core/random_setting.h"

namespace ghostforce::batch_test {
namespace {

constexpr std::int64_t ticks_on_the_way = 300;
constexpr std::int64_t ticks_held = 1500;

// Loops that settle within the ticks above, see random_stable_loop() in tick_test.cpp.
struct Loop {
  TickCoefficients<2> coefficients;
  StrategyId strategy;
  Vector<2> start;  // outside the wall [m]
  Vector<2> goal;   // inside, or just outside [m]
};

Loop random_loop(Random& random) {
  Setting<2> setting = random_setting<2>(random);
  Stiffnesses& k = setting.stiffnesses;
  k.k_r = k.k_u * random.over_decades(0.1, 3.0);
  if (random.once_in(3)) k.believed_k_u = k.k_u * random.over_decades(0.3, 3.0);
  if (random.once_in(4)) setting.goal += 0.2 * setting.wall.normal;
  const double rate = random.over_decades(100.0, 10000.0);
  const double omega = 2.0 * std::numbers::pi * rate / random.uniform(30.0, 60.0);
  const double mass = (k.k_u + k.k_r) / (omega * omega);
  const double damping = 2.0 * (k.k_u + k.k_r) / omega;
  return {coefficients_of(setting.wall, setting.actuation(), k, mass, damping, rate),
          strategy_catalog()[static_cast<std::size_t>(random.below(strategy_count))].id,
          setting.wall.point + 0.02 * setting.wall.normal, setting.goal};
}

std::vector<Loop> random_loops(Random& random, int count) {
  std::vector<Loop> loops;
  for (int i = 0; i < count; ++i) loops.push_back(random_loop(random));
  return loops;
}

Batch batch_of(const std::vector<Loop>& loops, Instructions instructions = widest_instructions()) {
  Batch batch(instructions);
  for (const Loop& loop : loops) {
    batch.add(loop.coefficients, loop.strategy, loop.start);
    batch.set_goal(batch.size() - 1, loop.goal);
  }
  return batch;
}

struct Ticked {
  TickState<2> state;
  StrategySnapshot<2> seen;
};

Ticked ticked(const Loop& loop, TickState<2> state, const std::vector<Vector<2>>& goals) {
  for (const Vector<2>& goal : goals) tick(loop.coefficients, goal, state);
  return {state, snapshot_of(loop.coefficients, state).strategies[index_of(loop.strategy)]};
}

// Each tick rounds by some ulp of the extent, and the slowest motion remembers some hundred ticks: 1e-13 of the extent,
// times the stiffnesses' ratio in proxy and force. No use of it needs more than 1e-9.
void expect_near(const Loop& loop, const Batch::Lane& lane, const Ticked& expected) {
  const double extent = glm::length(loop.start) + glm::length(loop.goal) + glm::length(loop.coefficients.wall.point);
  const double distance = 1e-11 * extent;
  const auto& strategy = loop.coefficients.strategies[index_of(loop.strategy)];
  const double gain = 1.0 + glm::length(strategy.proxy_gain);
  const double stiffness = glm::length(strategy.rendering[0]) + glm::length(strategy.rendering[1]);
  const Vector<2>& velocity = expected.state.strategies[index_of(loop.strategy)].motion.velocity;
  EXPECT_LE(glm::distance(lane.device, expected.seen.device), distance);
  EXPECT_LE(glm::distance(lane.velocity, velocity), distance * loop.coefficients.rate);
  EXPECT_LE(glm::distance(lane.proxy, expected.seen.proxy), distance * gain);
  EXPECT_LE(glm::distance(lane.force, expected.seen.force), distance * gain * stiffness);
}

// Any number of lanes: none, one, a block of eight and its neighbours.
TEST(Batch, MovesEachLaneAsTheTickDoes) {
  Random random(1);
  int in_contact = 0;
  int hard = 0;
  int lanes = 0;
  for (const int count : {0, 1, 7, 8, 9, 40}) {
    for (int repetition = 0; repetition < 20; ++repetition) {
      SCOPED_TRACE(std::to_string(count) + " lanes, " + std::to_string(repetition));
      const std::vector<Loop> loops = random_loops(random, count);
      Batch batch = batch_of(loops);
      ASSERT_EQ(batch.size(), loops.size());
      for (const std::int64_t ticks : {std::int64_t{0}, std::int64_t{1}, std::int64_t{60}, ticks_held}) {
        batch = batch_of(loops);
        batch.hold(ticks);
        for (std::size_t i = 0; i < loops.size(); ++i) {
          SCOPED_TRACE(std::to_string(ticks) + " ticks, lane " + std::to_string(i));
          const Loop& loop = loops[i];
          const Ticked expected =
              ticked(loop, state_at_start(loop.start), std::vector(static_cast<std::size_t>(ticks), loop.goal));
          expect_near(loop, batch[i], expected);
          if (ticks < ticks_held) continue;
          ++lanes;
          if (expected.seen.in_contact) ++in_contact;
          if (expected.seen.in_contact && glm::distance(expected.seen.proxy, expected.seen.contact) < 1e-12) ++hard;
        }
      }
    }
  }
  // Else the comparison says little.
  EXPECT_GT(in_contact, lanes / 2);
  EXPECT_LT(in_contact, lanes);
  EXPECT_GT(hard, lanes / 20);
}

TEST(Batch, FollowsAPathAsTheTickDoes) {
  Random random(2);
  const std::vector<Loop> loops = random_loops(random, 21);
  for (const bool held_afterwards : {false, true}) {
    std::vector<Vector<2>> goals;
    for (std::int64_t k = 1; k <= ticks_on_the_way; ++k) {
      const double angle = 0.01 * static_cast<double>(k);
      goals.push_back(0.1 * Vector<2>(std::cos(angle), std::sin(angle)));
    }
    Batch batch = batch_of(loops);
    batch.follow(goals);
    batch.follow({});
    if (held_afterwards) {
      batch.hold(100);
      goals.insert(goals.end(), 100, goals.back());
    }
    for (std::size_t i = 0; i < loops.size(); ++i) {
      SCOPED_TRACE(i);
      expect_near(loops[i], batch[i], ticked(loops[i], state_at_start(loops[i].start), goals));
    }
  }
}

void expect_same(const Batch::Lane& one, const Batch::Lane& other) {
  EXPECT_EQ(one.device, other.device);
  EXPECT_EQ(one.velocity, other.velocity);
  EXPECT_EQ(one.proxy, other.proxy);
  EXPECT_EQ(one.force, other.force);
}

// To the last bit: neither by the instructions, nor by how the ticks are cut into calls, nor by the neighbours.
TEST(Batch, ALaneDependsOnNothingElse) {
  Random random(3);
  const std::vector<Loop> loops = random_loops(random, 21);
  Batch whole = batch_of(loops);
  Batch baseline = batch_of(loops, Instructions::baseline);
  Batch in_pieces = batch_of(loops);
  whole.hold(200);
  baseline.hold(200);
  for (const std::int64_t ticks : {1, 2, 3, 194}) in_pieces.hold(ticks);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    SCOPED_TRACE(i);
    Batch alone = batch_of({loops[i]});
    alone.hold(200);
    expect_same(baseline[i], whole[i]);
    expect_same(in_pieces[i], whole[i]);
    expect_same(alone[0], whole[i]);
  }
}

TEST(Batch, TheLastLaneTakesTheRemovedOnesPlace) {
  Random random(4);
  const std::vector<Loop> loops = random_loops(random, 17);
  Batch whole = batch_of(loops);
  whole.hold(200);

  Batch batch = batch_of(loops);
  batch.hold(100);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < loops.size(); ++i) left.push_back(i);
  for (const std::size_t lane : {16U, 0U, 14U, 3U, 3U}) {
    batch.remove(lane);
    left[lane] = left.back();
    left.pop_back();
  }
  batch.hold(100);
  ASSERT_EQ(batch.size(), left.size());
  for (std::size_t i = 0; i < left.size(); ++i) expect_same(batch[i], whole[left[i]]);

  // A new one where there has been another, and in a batch that has become empty.
  while (true) {
    const std::size_t lane = batch.size();
    batch.add(loops[5].coefficients, loops[5].strategy, loops[5].start);
    batch.set_goal(lane, loops[5].goal);
    batch.hold(200);
    expect_same(batch[lane], whole[5]);
    if (lane == 0) break;
    while (batch.size() > 0) batch.remove(0);
  }
}

}  // namespace
}  // namespace ghostforce::batch_test
