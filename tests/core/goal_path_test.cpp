#include "core/goal_path.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace ghostforce::goal_path_test {
namespace {

// Positions within 0.1 m, a handful of roundings.
constexpr double rounding = 8.0 * 0.1 * std::numeric_limits<double>::epsilon();

GoalPath zigzag(Motion motion) {
  return {{{-0.04, 0.04}, {0.04, -0.04}, {0.03, 0.1}, {0.03, 0.1}}, {0.0, 1.0, 1.5, 4.0}, motion};
}

void expect_near(const Vector<2>& actual, const Vector<2>& expected, double tolerance) {
  EXPECT_LE(glm::length(actual - expected), tolerance) << actual.x << ' ' << actual.y;
}

TEST(GoalPathTest, IsExactAtTheWaypoints) {
  for (const Motion motion : {Motion::linear, Motion::minimum_jerk}) {
    const GoalPath path = zigzag(motion);
    for (std::size_t i = 0; i < path.points.size(); ++i) EXPECT_EQ(goal_at(path, path.times[i]), path.points[i]);
  }
}

TEST(GoalPathTest, HoldsBeforeAndAfter) {
  for (const Motion motion : {Motion::linear, Motion::minimum_jerk}) {
    const GoalPath path = zigzag(motion);
    for (const double before : {-1e-9, -1.0, -1e9}) EXPECT_EQ(goal_at(path, before), path.points.front());
    for (const double after : {4.0, 4.0000001, 1e9}) EXPECT_EQ(goal_at(path, after), path.points.back());
    for (const double rest : {1.5, 2.0, 3.9}) EXPECT_EQ(goal_at(path, rest), path.points.back());
  }
}

TEST(GoalPathTest, OneWaypointIsAHandThatStandsStill) {
  const GoalPath path{{{0.01, 0.02}}, {0.0}, Motion::minimum_jerk};
  for (const double time : {-1.0, 0.0, 0.5, 100.0}) EXPECT_EQ(goal_at(path, time), Vector<2>(0.01, 0.02));
}

TEST(GoalPathTest, LinearMovesAtConstantVelocity) {
  const GoalPath path = zigzag(Motion::linear);
  expect_near(goal_at(path, 0.25), {-0.02, 0.02}, rounding);
  expect_near(goal_at(path, 0.5), {0.0, 0.0}, rounding);
  expect_near(goal_at(path, 1.25), {0.035, 0.03}, rounding);
  for (double time = 0.0; time < 1.0; time += 0.01) {
    expect_near(goal_at(path, time), {-0.04 + 0.08 * time, 0.04 - 0.08 * time}, rounding);
  }
}

// 10 s³ − 15 s⁴ + 6 s⁵, at shares that are exact in binary.
TEST(GoalPathTest, MinimumJerkFollowsItsPolynomial) {
  const GoalPath path = zigzag(Motion::minimum_jerk);
  const Vector<2> from = path.points[0];
  const Vector<2> way = path.points[1] - path.points[0];
  expect_near(goal_at(path, 0.25), from + 0.103515625 * way, rounding);
  expect_near(goal_at(path, 0.5), from + 0.5 * way, rounding);
  expect_near(goal_at(path, 0.75), from + 0.896484375 * way, rounding);
  const Vector<2> second_way = path.points[2] - path.points[1];
  expect_near(goal_at(path, 1.0 + 0.5 * 0.25), path.points[1] + 0.103515625 * second_way, rounding);
}

// No velocity and no acceleration at either end of a stretch: near an end the way grows with the third power of time.
TEST(GoalPathTest, MinimumJerkStartsAndStopsSmoothly) {
  const GoalPath path = zigzag(Motion::minimum_jerk);
  const double way = glm::length(path.points[1] - path.points[0]);
  for (const double h : {1e-2, 1e-3}) {
    EXPECT_NEAR(glm::length(goal_at(path, h) - path.points[0]) / (10.0 * way * h * h * h), 1.0, 2.0 * h);
    EXPECT_NEAR(glm::length(goal_at(path, 1.0 - h) - path.points[1]) / (10.0 * way * h * h * h), 1.0, 2.0 * h);
  }
  // It peaks at 15/8 of the mean velocity, half way.
  const double h = 1e-4;
  const double peak = glm::length(goal_at(path, 0.5 + h) - goal_at(path, 0.5 - h)) / (2.0 * h);
  EXPECT_NEAR(peak / way, 15.0 / 8.0, 1e-6);  // central difference: h² times the third derivative, 60 h²/6
}

TEST(GoalPathTest, HasNoJump) {
  for (const Motion motion : {Motion::linear, Motion::minimum_jerk}) {
    const GoalPath path = zigzag(motion);
    constexpr double step = 1e-4;
    constexpr double fastest = 0.14 / 0.5 * 15.0 / 8.0;  // the second stretch, minimum-jerk's peak
    for (double time = -0.1; time < 4.1; time += step) {
      EXPECT_LE(glm::length(goal_at(path, time + step) - goal_at(path, time)), 1.01 * fastest * step);
    }
  }
}

static_assert(noexcept(goal_at(GoalPath{}, 0.0)));

}  // namespace
}  // namespace ghostforce::goal_path_test
