// One device's numbers and axes.
#include "device/falcon/calibration.h"

#include <string>
#include <type_traits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace ghostforce {
namespace {

// Handed to the servo thread as a value.
static_assert(std::is_trivially_copyable_v<FalconCalibration>);

TEST(FalconSerial, KeepsWhatFits) {
  EXPECT_EQ(FalconSerial{}.text(), "");
  EXPECT_EQ(FalconSerial::from("12PZ657E")->text(), "12PZ657E");
  EXPECT_TRUE(FalconSerial::from(std::string(FalconSerial::longest, 'A')));
  EXPECT_FALSE(FalconSerial::from(std::string(FalconSerial::longest + 1, 'A')));
  EXPECT_EQ(FalconSerial::from("A"), FalconSerial::from("A"));
  EXPECT_NE(FalconSerial::from("A"), FalconSerial::from("B"));
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

}  // namespace
}  // namespace ghostforce
