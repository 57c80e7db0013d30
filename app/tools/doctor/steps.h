// The catalog of measurements of a Falcon, in the order in which they are taken: each uses what the ones before it have
// found, through the rig's calibration. A new one is a function here and a row in measurement.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/tools/doctor/rig.h"

namespace ghostforce {

// What one measurement of a Falcon has found, for the report. A plain value.
struct Finding {
  enum class State : std::uint8_t {
    as_assumed,    // the device is what the program takes every device for
    differs,       // it is not, and the calibration says so now
    measured,      // nothing was assumed
    not_measured,  // skipped, or there was no reading to trust
    contradicts,   // the readings do not go with each other
  };

  State state = State::not_measured;
  std::string title{};                  // what was to be found
  std::string sentence{};               // the result with its uncertainty, or why there is none
  std::string settles{};                // what nobody had confirmed; empty: nothing
  std::vector<std::string> readings{};  // each, as it was taken

  static constexpr State as_assumed_if(bool is_so) noexcept { return is_so ? State::as_assumed : State::differs; }
  bool is_answer() const noexcept { return state != State::not_measured && state != State::contradicts; }
};

constexpr std::string_view words_of(Finding::State state) noexcept {
  // In the order of Finding::State.
  constexpr std::array<std::string_view, 5> words{"as assumed", "differs from what was assumed", "measured",
                                                  "not measured", "the readings contradict each other"};
  return words[static_cast<std::size_t>(state)];
}

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
