// The catalog of measurements of a Haply 2DIY, in the order in which they are taken: each uses what the ones before it have
// found, through the rig. A new one is a function here and a row in haply_measurement.cpp.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "app/tools/doctor/finding.h"
#include "app/tools/doctor/haply_readings.h"
#include "app/tools/doctor/haply_rig.h"

namespace ghostforce {

struct HaplyStep {
  // What must have been measured before, because this one builds on it.
  enum class Needs : std::uint8_t { nothing, zero_pose, encoders, motors, friction };

  std::string_view title;
  std::string_view outline;  // what the person will do, and whether motors push
  // Throws as the rig does. What it finds goes into the rig's calibration too.
  std::vector<Finding> (*take)(HaplyRig& rig);
  Needs needs = Needs::nothing;
  Needs gives = Needs::nothing;
};

std::vector<Finding> measure_haply_port(HaplyRig& rig);
std::vector<Finding> measure_haply_zero_pose(HaplyRig& rig);
std::vector<Finding> measure_haply_encoders(HaplyRig& rig);
std::vector<Finding> measure_haply_motor_signs(HaplyRig& rig);
std::vector<Finding> measure_haply_friction(HaplyRig& rig);
std::vector<Finding> measure_haply_strength(HaplyRig& rig);
std::vector<Finding> measure_haply_silence(HaplyRig& rig);
std::vector<Finding> measure_haply_stiffness(HaplyRig& rig);

}  // namespace ghostforce
