#include "device/input/circle_input.h"

#include <gtest/gtest.h>

#include "tests/device/servo/servo_scenes.h"

namespace ghostforce::circle_input_test {
namespace {

constexpr double rate = 1000.0;
constexpr Circle circle{{0.02, -0.01}, 0.008, 0.25};
constexpr Vector<2> start{0.014, -0.014};

TEST(CircleInputTest, GoesFromWhereTheHandIsToTheCircleWithoutAStepAndThenRoundIt) {
  CircleInput input(circle);
  input.restart(start);
  EXPECT_EQ(input.goal(0, rate), start);
  Vector<2> before = start;
  for (int k = 1; k <= 9000; ++k) {
    const Vector<2> now = input.goal(k, rate);
    // Minimum jerk is at most 1.875 times as fast as steady: 16 mm in 0.5 s at most, and the circle's own speed.
    ASSERT_LT(glm::distance(before, now), 1.875 * 0.016 / 500.0 + 2e-5) << k;
    if (k >= 500) {
      ASSERT_NEAR(glm::distance(now, circle.center), circle.radius, 1e-15) << k;
    }
    before = now;
  }
  EXPECT_LT(glm::distance(input.goal(500 + 4000, rate), input.goal(500, rate)), 1e-15) << "a turn";
  const Vector<2> first = input.goal(500, rate) - circle.center;
  const Vector<2> next = input.goal(600, rate) - circle.center;
  EXPECT_GT(first.x * next.y - first.y * next.x, 0.0) << "counter-clockwise";
}

TEST(CircleInputTest, TakesAnotherCircleWithARestartOnly) {
  CircleInput input(circle);
  input.restart(start);
  const Circle other{{0.05, 0.0}, 0.003, -0.25};
  input.go_round(other);
  // 0.7 s − 0.5 s is not the 0.2 s next to it.
  EXPECT_LT(glm::distance(input.goal(700, rate), position_on(circle, 0.2)), 1e-15);
  input.restart(start);
  EXPECT_EQ(input.goal(0, rate), start);
  EXPECT_LT(glm::distance(input.goal(700, rate), position_on(other, 0.2)), 1e-15);
}

TEST(CircleInputTest, LeadsAServoRoundInContact) {
  const Scene scene = slanted_wall();
  ServoCommand command = start_of(scene);
  command.restart_state = state_at_start(scene.goal.points.back());
  const Circle inside = circle_inside(wall_of(scene.settings), scene.goal.points.back(), {});
  Servo servo(std::make_unique<CircleInput>(inside), command);
  for (int k = 0; k < 5000; ++k) {
    servo.step();
    if (k < 100) continue;
    for (const auto& strategy : servo.newest().snapshot.strategies) ASSERT_TRUE(strategy.in_contact) << k;
  }
}

}  // namespace
}  // namespace ghostforce::circle_input_test
