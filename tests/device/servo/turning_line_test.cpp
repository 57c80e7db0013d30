// A device whose motor pushes along a line that turns with its handle.
#include <algorithm>
#include <cmath>

#include "tests/device/servo/puppet_servo.h"

namespace ghostforce::turning_line_test {
namespace {

class TurningLine : public PuppetServo {};

TEST_F(TurningLine, AMotorWhoseLineTurnsPushesAlongWhereTheLineIsNow) {
  puppet_->reading.motor_angle = 0.3;
  turn_on();
  puppet_->reading.position = inside;
  std::uint64_t turns = 0;
  for (double angle = 0.3; angle < 1.2; angle += 0.001) {
    puppet_->reading.motor_angle = angle;
    step();
    const Vector<2> line = direction_at(motors().line_angle);
    // A recording tells it in degrees, with five digits behind the point.
    EXPECT_NEAR(motors().line_angle, angle, 1e-7);
    EXPECT_NEAR(puppet_->pushed.x * line.y - puppet_->pushed.y * line.x, 0.0, 1e-12) << angle;
    ++turns;
  }
  EXPECT_GT(turns, 800U);
  EXPECT_TRUE(motors().line_turns);
  EXPECT_EQ(motors().state, SafetyState::on);
  EXPECT_GT(glm::length(puppet_->pushed), 0.2);
  // The window's settings change what they are about, and leave the line to the device.
  command_.settings.actuated_angle = -1.0;
  command_.settings.stiffnesses.k_r = 300.0;
  ++command_.settings_generation;
  run(0.3);
  Settings expected = command_.settings;
  expected.actuated_angle = motors().line_angle;
  EXPECT_NEAR(glm::length(puppet_->pushed - wanted(inside, expected)), 0.0, 1e-12);
  Sample newest;
  for (Sample sample; servo_->take_sample(sample);) newest = sample;
  EXPECT_EQ(newest.settings.actuated_angle, motors().line_angle);
}

// At another motor, whose line is another one: as from one strategy to another.
TEST_F(TurningLine, FromOneMotorToTheOtherTheForceLeadsOver) {
  puppet_->reading.motor_angle = 0.3;
  turn_on();
  puppet_->reading.position = inside;
  run(0.3);
  const Vector<2> before = puppet_->pushed;
  puppet_->reading.motor_angle = 1.3;
  puppet_->reading.pushing_motor = 1;
  Settings expected = command_.settings;
  step();
  expected.actuated_angle = motors().line_angle;
  const Vector<2> after = wanted(inside, expected);
  ASSERT_GT(glm::distance(before, after), 0.1);
  double longest_step = glm::distance(before, puppet_->pushed);
  int steps = 1;
  while (glm::distance(puppet_->pushed, after) > 1e-9 && steps < 1000) {
    const Vector<2> last = puppet_->pushed;
    step();
    longest_step = std::max(longest_step, glm::distance(last, puppet_->pushed));
    ++steps;
  }
  EXPECT_LT(longest_step, 0.05 * glm::distance(before, after));
  EXPECT_GE(steps, 100);
  EXPECT_LE(steps, 200);
  EXPECT_EQ(motors().state, SafetyState::on);
}

TEST_F(TurningLine, NoTonesSoundAlongALineThatTurns) {
  puppet_->reading.motor_angle = 0.0;
  command_.measures_hand = true;
  turn_on();
  puppet_->reading.position = inside;
  for (int i = 0; i < 2000; ++i) {
    step();
    EXPECT_FALSE(report().hand.is_measuring);
    EXPECT_EQ(report().hand.tone_gain, 0.0);
  }
  EXPECT_NEAR(glm::length(puppet_->pushed - wanted(inside, command_.settings)), 0.0, 1e-12) << "nothing but the wall";
}

TEST_F(TurningLine, ADeviceThatCannotGiveTheForceSaysSo) {
  turn_on();
  puppet_->reading.position = inside;
  run(0.1);
  EXPECT_FALSE(motors().is_saturated);
  puppet_->reading.is_saturated = true;
  step();
  EXPECT_TRUE(motors().is_saturated);
}

}  // namespace
}  // namespace ghostforce::turning_line_test
