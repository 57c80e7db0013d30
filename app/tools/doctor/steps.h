// The catalog of measurements of a Falcon, in the order in which they are taken: each uses what the ones before it have
// found, through the rig's calibration. A new one is a function here and a row in measurement.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "app/tools/doctor/finding.h"
#include "app/tools/doctor/rig.h"

namespace ghostforce {

struct MeasureStep {
  // What must have been measured before, because this one builds on it: without it motors would push anywhere.
  enum class Needs : std::uint8_t { nothing, encoders, motors };

  std::string_view title;
  std::string_view outline;  // what the person will do, and whether motors push
  // Throws as the rig does. What it finds goes into the rig's calibration too.
  std::vector<Finding> (*take)(MeasuringRig& rig);
  Needs needs = Needs::nothing;
  Needs gives = Needs::nothing;
};

std::span<const MeasureStep> measure_step_catalog() noexcept;

std::vector<Finding> measure_encoders(MeasuringRig& rig);
std::vector<Finding> measure_lengths(MeasuringRig& rig);
std::vector<Finding> measure_motor_signs(MeasuringRig& rig);
std::vector<Finding> measure_motor_constant(MeasuringRig& rig);
std::vector<Finding> measure_silence(MeasuringRig& rig);
std::vector<Finding> measure_exchanges(MeasuringRig& rig);
std::vector<Finding> check_lights(MeasuringRig& rig);
std::vector<Finding> check_buttons(MeasuringRig& rig);

}  // namespace ghostforce
