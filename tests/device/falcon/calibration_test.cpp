// One device's numbers and axes.
#include "device/falcon/calibration.h"

#include <string>
#include <type_traits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace ghostforce::calibration_test {
namespace {

// Handed to the servo thread as a value.
static_assert(std::is_trivially_copyable_v<FalconCalibration>);

TEST(DeviceSerial, KeepsWhatFits) {
  EXPECT_EQ(DeviceSerial{}.text(), "");
  EXPECT_EQ(DeviceSerial::from("12PZ657E")->text(), "12PZ657E");
  EXPECT_TRUE(DeviceSerial::from(std::string(DeviceSerial::longest, 'A')));
  EXPECT_FALSE(DeviceSerial::from(std::string(DeviceSerial::longest + 1, 'A')));
  EXPECT_EQ(DeviceSerial::from("A"), DeviceSerial::from("A"));
  EXPECT_NE(DeviceSerial::from("A"), DeviceSerial::from("B"));
}

TEST(FalconAxis, PointsWhereItsNameSays) {
  EXPECT_EQ(direction_of(FalconAxis::x), Vector<3>(1, 0, 0));
  EXPECT_EQ(direction_of(FalconAxis::minus_y), Vector<3>(0, -1, 0));
  EXPECT_EQ(direction_of(FalconAxis::minus_z), Vector<3>(0, 0, -1));
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      const auto first = static_cast<FalconAxis>(a);
      const auto second = static_cast<FalconAxis>(b);
      EXPECT_EQ(are_parallel(first, second), glm::dot(direction_of(first), direction_of(second)) != 0.0);
    }
  }
}

TEST(FalconCalibration, OffsetsAreAddedToTheEncoders) {
  FalconCalibration calibration;
  EXPECT_EQ(joint_angles({0, 0, 0}, calibration), Vector<3>(calibration.geometry.angle_at_zero_count));
  calibration.encoder_offset = {0, 32767, -5};
  // Beyond what 16 bits hold.
  EXPECT_EQ(joint_angles({7, 32767, 5}, calibration), angles_of_counts({7.0, 65534.0, 0.0}, calibration.geometry));
}

TEST(FalconCalibration, LegsTakeTheirNumbersFromWhereTheyAre) {
  FalconCalibration calibration;
  calibration.encoder_of_leg = {3, -1, 2};
  calibration.encoder_offset = {1000, 0, 7};
  EXPECT_EQ(leg_counts({10.0, 20.0, 30.0}, calibration), Vector<3>(37.0, -1010.0, 20.0));
  EXPECT_EQ(in_frame_order({100, 200, 300}, {3, -1, 2}), (MotorNumbers{-200, 300, 100}));
}

TEST(FalconCalibration, LegNumbersAreEachOnce) {
  for (const LegNumbers& good : {LegNumbers{1, 2, 3}, LegNumbers{-3, 1, -2}, LegNumbers{2, 3, 1}}) {
    EXPECT_TRUE(are_leg_numbers(good));
  }
  for (const LegNumbers& bad : {LegNumbers{1, 2, 2}, LegNumbers{0, 1, 2}, LegNumbers{1, -1, 2}, LegNumbers{1, 2, 4},
                                LegNumbers{1, 2, -4}, LegNumbers{127, 2, 3}, LegNumbers{-128, 2, 3}}) {
    EXPECT_FALSE(are_leg_numbers(bad));
  }
}

// Weak motors are asked for more, and the one that pushes the other way for less.
TEST(FalconCalibration, MotorNumbersMakeTheForceOnSuchADevice) {
  FalconCalibration calibration;
  calibration.motor_strengths = {1.0, 0.5, 0.8};
  calibration.motor_of_leg = {2, -3, 1};
  const Matrix<3> jacobian = *FalconKinematics(calibration.geometry).jacobian({0.01, 0.0, 0.12});
  const Vector<3> force(0.5, 1.0, -0.7);
  const MotorNumbers numbers = motor_numbers(force, jacobian, calibration);
  const Vector<3> legs(numbers[1], -numbers[2], numbers[0]);
  const Vector<3> made = force_of_motor_counts(legs, jacobian, 6600.0 / calibration.motor_strengths);
  EXPECT_LT(glm::length(made - force), 0.01);
  EXPECT_EQ(motor_numbers(force, Matrix<3>(0.0), calibration), MotorNumbers{});
}

}  // namespace
}  // namespace ghostforce::calibration_test
