// The direction test on a handle of two axes in a simulated hand: thousands of hands in the time in which a whole
// simulated device has one.
#include "device/motors/direction_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "core/tremor_and_drift.h"
#include "tests/support/hand_at_wall.h"
#include "tests/support/long_run.h"

namespace ghostforce::direction_test_test {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr double armed_s = 1.2;

// A mass on a spring and a damper for each of two axes, each moved by its motor, and by the other one by a third as
// much. The hand trembles, drifts, and goes elsewhere.
struct Hand {
  double stiffness = 100.0;  // [N/m]
  double mass = 0.15;        // [kg]
  double damping = 5.0;      // [N·s/m]
  double friction = 0.0;     // [N]
  double lever = 0.06;       // of both motors [m]
  double counts_per_turn = 4880.0;
  TremorAndDrift tremor_and_drift{};
  std::array<std::vector<Submovement>, 2> moves{};
  Vector<2> signs{1.0};  // −1: a motor pushes the wrong way
};

struct Result {
  MotorFinding finding;
  bool is_done = false;
  double lasted_s = 0.0;
  double greatest_force = 0.0;
  double longest_pulse_s = 0.0;
};

double goal_of(const std::vector<Submovement>& moves, double time_s) {
  double goal = 0.0;
  for (const Submovement& move : moves) {
    const double share = std::clamp((time_s - move.from_s) / move.lasts_s, 0.0, 1.0);
    goal += move.way[0] * share * share * share * (10.0 - 15.0 * share + 6.0 * share * share);
  }
  return goal;
}

Result test_in(const Hand& hand) {
  constexpr int substeps = 4;
  constexpr double step_s = 1e-3 / substeps;
  const TremorAndDriftMotion motion(hand.tremor_and_drift);
  const double count_angle = 2.0 * std::numbers::pi / hand.counts_per_turn;
  MotorCheck check(2);  // tells whether the hand is still
  DirectionTest test(2);
  Result result;
  Vector<2> place(0.0);
  Vector<2> speed(0.0);
  Vector<3> torques(0.0);
  double pulse_s = 0.0;
  double force_before = 0.0;
  for (std::int64_t i = 0; i < 9000; ++i) {
    const double time_s = 1e-3 * static_cast<double>(i);
    const std::int64_t now_ns = (1000 + i) * ms;
    const Vector<2> angles = count_angle * glm::floor(place / hand.lever / count_angle);
    const MotorCheck::Reading reading{.time_ns = now_ns, .angles = {angles.x, angles.y, 0.0}, .torques = torques};
    const Vector<3> levers(hand.lever, hand.lever, 1.0);
    check.add(reading, count_angle, levers);
    test.add(reading, count_angle, levers, check.is_still());
    if (time_s == armed_s) test.begin();
    const MotorCheck::Push push = test.push_at(now_ns);
    torques = Vector<3>(0.0);
    torques[static_cast<glm::length_t>(push.leg)] = push.force * hand.lever;
    result.greatest_force = std::max(result.greatest_force, std::abs(push.force));
    pulse_s = push.force != 0.0 && push.force * force_before >= 0.0 ? pulse_s + 1e-3 : 0.0;
    force_before = push.force;
    result.longest_pulse_s = std::max(result.longest_pulse_s, pulse_s);
    result.finding = test.finding();
    result.is_done = test.is_done();
    result.lasted_s = time_s - armed_s;
    if (result.is_done || has_failed(result.finding.verdict)) return result;
    const Vector<2> own = motion.at(time_s);
    for (int substep = 0; substep < substeps; ++substep) {
      for (glm::length_t axis = 0; axis < 2; ++axis) {
        const double pushed = hand.signs[axis] * torques[axis] + 0.3 * hand.signs[1 - axis] * torques[1 - axis];
        const double goal = own[axis] + goal_of(hand.moves[static_cast<std::size_t>(axis)], time_s);
        const double force = pushed / hand.lever + hand.stiffness * (goal - place[axis]) - hand.damping * speed[axis] -
                             hand.friction * std::tanh(speed[axis] / 1e-3);
        speed[axis] += step_s * force / hand.mass;
        place[axis] += step_s * speed[axis];
      }
    }
  }
  return result;
}

Hand any_hand(HandRandom& random, double least, double greatest) {
  Hand hand;
  hand.stiffness = random.over_decades(least, greatest);
  hand.mass = random.over_decades(0.08, 0.5);
  hand.damping = 2.0 * random.uniform(0.15, 1.2) * std::sqrt(hand.stiffness * hand.mass);
  hand.friction = random.uniform(0.0, 1.0) < 0.5 ? 0.0 : random.uniform(0.0, 0.03);
  hand.lever = random.uniform(0.045, 0.075);
  hand.counts_per_turn = random.uniform(0.0, 1.0) < 0.5 ? 4880.0 : 2440.0;
  hand.tremor_and_drift.tremor_rms = random.uniform(0.0, 1.0) < 0.3 ? 0.0 : random.over_decades(10e-6, 300e-6);
  hand.tremor_and_drift.drift_speed = random.uniform(0.0, 1.0) < 0.3 ? 0.0 : random.over_decades(0.5e-3, 10e-3);
  hand.tremor_and_drift.seed = std::floor(random.uniform(1.0, 1e6));
  return hand;
}

// A hand that goes to and fro as it likes, in moves of at most so long each.
void add_moves(Hand& hand, double longest_s, HandRandom& random) {
  for (auto& moves : hand.moves) {
    for (double time_s = random.uniform(0.5, 2.0); time_s < 9.0;) {
      const double lasts_s = random.uniform(0.08, longest_s);
      const double way = random.uniform(-1.0, 1.0) * random.over_decades(1e-3, 40e-3);
      moves.push_back({time_s, lasts_s, {way, 0.0}});
      time_s += lasts_s + random.uniform(0.0, longest_s);
    }
  }
}

TEST(DirectionTest, LetsRightMotorsPass) {
  for (const double stiffness : {20.0, 100.0, 300.0, 1000.0}) {
    const Result result = test_in({.stiffness = stiffness});
    EXPECT_TRUE(result.is_done) << stiffness;
    EXPECT_LT(result.lasted_s, 1.8) << stiffness;
    EXPECT_LE(result.greatest_force, 0.25);
    EXPECT_NEAR(result.longest_pulse_s, 2.0 * DirectionTest::pulse_s, 2e-3);
  }
}

TEST(DirectionTest, NamesTheMotorThatPushesTheWrongWay) {
  for (const std::size_t motor : {0U, 1U}) {
    for (const double stiffness : {20.0, 100.0, 200.0}) {
      Hand hand{.stiffness = stiffness};
      hand.signs[static_cast<glm::length_t>(motor)] = -1.0;
      const Result result = test_in(hand);
      EXPECT_EQ(result.finding, (MotorFinding{MotorVerdict::wrong_way, motor})) << stiffness;
      EXPECT_LE(result.greatest_force, 0.25);
      EXPECT_LT(result.lasted_s, 3.5);
    }
  }
}

TEST(DirectionTest, GivesLessTorqueWhereALittleIsALargeForceAndLessForceWhereALimitIsLower) {
  for (const double lever : {0.02, 0.05, 0.1}) {
    const Result result = test_in({.lever = lever});
    EXPECT_DOUBLE_EQ(result.greatest_force, std::min(0.015 / lever, DirectionTest::greatest_force));
  }
  DirectionTest test(2);
  test.set_force_limit(0.1);
  test.begin();
  double greatest = 0.0;
  for (std::int64_t i = 0; i < 2000; ++i) {
    test.add({.time_ns = i * ms}, 1e-3, Vector<3>(0.05), true);
    greatest = std::max(greatest, std::abs(test.push_at(i * ms).force));
  }
  EXPECT_DOUBLE_EQ(greatest, 0.1);
}

TEST(DirectionTest, WaitsForAHandThatIsStillAndPushesNothingOnceItIsOver) {
  DirectionTest test(2);
  test.begin();
  for (std::int64_t i = 0; i < 2000; ++i) {
    test.add({.time_ns = i * ms}, 1e-3, Vector<3>(0.05), false);
    EXPECT_EQ(test.push_at(i * ms).force, 0.0);
  }
  test.end();
  test.add({.time_ns = 2000 * ms}, 1e-3, Vector<3>(0.05), true);
  EXPECT_EQ(test.push_at(2000 * ms).force, 0.0);
  EXPECT_FALSE(test.is_done());
}

// A reply that is missing for longer than ten milliseconds ends a train, and it is made again.
TEST(DirectionTest, BeginsATrainAnewAfterAHole) {
  DirectionTest test(2);
  test.begin();
  std::int64_t now_ns = 0;
  const auto run = [&](int steps) {
    double pushed = 0.0;
    for (int i = 0; i < steps; ++i) {
      now_ns += ms;
      test.add({.time_ns = now_ns}, 1e-3, Vector<3>(0.05), true);
      pushed += std::abs(test.push_at(now_ns).force);
    }
    return pushed;
  };
  EXPECT_EQ(run(600), 0.0) << "the hand has not been watched for long enough";
  EXPECT_GT(run(300), 0.0);
  now_ns += 20 * ms;
  EXPECT_EQ(run(100), 0.0);
  EXPECT_GT(run(900), 0.0);
}

TEST(DirectionTest, TakesNoRightMotorForAWrongOne) {
  HandRandom random(20261129);
  const int hands = is_long_run() ? 20000 : 400;
  int done = 0;
  for (int i = 0; i < hands; ++i) {
    Hand hand = any_hand(random, 20.0, 1000.0);
    if (i % 4 == 1) add_moves(hand, 0.8, random);
    if (i % 4 == 2) add_moves(hand, 0.2, random);
    // Slow and large, as of a person who has such an illness.
    if (i % 4 == 3) hand.tremor_and_drift.tremor_hz = {3.0, 7.0};
    if (i % 4 == 3) hand.tremor_and_drift.tremor_rms = random.over_decades(50e-6, 1e-3);
    const Result result = test_in(hand);
    EXPECT_FALSE(has_failed(result.finding.verdict)) << static_cast<int>(result.finding.verdict) << ", " << i << ": "
                                                     << hand.stiffness << " N/m, " << hand.mass << " kg";
    done += result.is_done ? 1 : 0;
    EXPECT_LE(result.greatest_force, 0.25);
  }
  // Some never hold still.
  EXPECT_GT(done, hands / 2);
}

TEST(DirectionTest, FindsAWrongMotorInMostHandsThatHoldLoosely) {
  HandRandom random(20261130);
  const int hands = is_long_run() ? 5000 : 150;
  int found = 0;
  for (int i = 0; i < hands; ++i) {
    Hand hand = any_hand(random, 20.0, 150.0);
    hand.signs[i % 2] = -1.0;
    const Result result = test_in(hand);
    found += result.finding == MotorFinding{MotorVerdict::wrong_way, static_cast<std::size_t>(i % 2)} ? 1 : 0;
    EXPECT_LE(result.greatest_force, 0.25);
  }
  EXPECT_GT(10 * found, 7 * hands);
}

}  // namespace
}  // namespace ghostforce::direction_test_test
