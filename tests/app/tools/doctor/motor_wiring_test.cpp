// Which motor is which, from how the legs moved.
#include "app/tools/doctor/motors.h"

#include <gtest/gtest.h>

namespace ghostforce::motor_wiring_test {
namespace {

// Above 0 pulls in: that leg's counts shrink, and the others move a little too.
std::array<MotorPulse, 3> good_pulses() {
  return {MotorPulse{200.0, {-60.0, 10.0, 8.0}}, MotorPulse{200.0, {9.0, -50.0, 12.0}},
          MotorPulse{200.0, {11.0, 9.0, -70.0}}};
}

TEST(MotorWiring, OfADeviceAsAssumed) {
  const MotorWiring found = find_motor_wiring(good_pulses());
  EXPECT_EQ(found.problem, MotorProblem::none);
  EXPECT_EQ(found.motor_of_leg, legs_in_order);
}

TEST(MotorWiring, FindsSignsAndOrder) {
  auto pulses = good_pulses();
  pulses[1].moved *= -1.0;
  EXPECT_EQ(find_motor_wiring(pulses).motor_of_leg, (LegNumbers{1, -2, 3}));
  std::swap(pulses[0], pulses[1]);
  EXPECT_EQ(find_motor_wiring(pulses).motor_of_leg, (LegNumbers{2, -1, 3}));
  pulses = good_pulses();
  for (MotorPulse& pulse : pulses) pulse.counts *= -1.0;
  EXPECT_EQ(find_motor_wiring(pulses).motor_of_leg, (LegNumbers{-1, -2, -3}));
}

TEST(MotorWiring, ConcludesNothingFromNothing) {
  auto pulses = good_pulses();
  pulses[2].moved = Vector<3>(3.0, 4.0, -7.9);
  EXPECT_EQ(find_motor_wiring(pulses).problem, MotorProblem::no_movement);
  pulses = good_pulses();
  pulses[2].moved = pulses[0].moved;
  EXPECT_EQ(find_motor_wiring(pulses).problem, MotorProblem::same_leg_twice);
}

}  // namespace
}  // namespace ghostforce::motor_wiring_test
