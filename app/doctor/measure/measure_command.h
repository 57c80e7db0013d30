// ghostforce doctor --measure: opens the Falcon, has it measured, and writes the report and the calibration. UI thread.
#pragma once

#include <optional>
#include <string>

#include "app/cli/falcon_options.h"

namespace ghostforce {

struct MeasureCall {
  FalconSetUp falcon;
  bool is_virtual = false;
  std::string report = "-";                // path; -: the standard output
  std::optional<std::string> calibration;  // path; none: where calibrations are kept, if the person wants that
};

// Returns the exit code. Throws Failure.
int measure_with_doctor(const MeasureCall& call);

}  // namespace ghostforce
