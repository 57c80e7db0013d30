// The measurement of one Falcon: leads a person through the catalog of steps and gathers what they find. UI thread.
#pragma once

#include <string>
#include <vector>

#include "app/tools/doctor/rig.h"
#include "app/tools/doctor/steps.h"
#include "device/falcon/falcon.h"

namespace ghostforce {

struct FalconMeasurement {
  using Step = MeasuredStep;
  std::vector<Step> steps;
  FalconCalibration calibration;  // with all that was found
  bool is_complete = false;       // false: the person left before the end and wants the report of what there is

  // Whether every finding is an answer.
  bool has_all_answers() const { return is_complete && ghostforce::has_all_answers(steps); }
};

// Until the device is homed: drives it as the window would, motors off, and tells the person what to do. Throws Failure
// with the exit code of what is in the way.
void await_homed(Falcon& falcon, Operator& person);

// With a device that is homed. Motors are off when it returns or throws. `before` is what was kept for this device; of
// it stays how the wall lies in the workspace, and the rest is measured anew. Throws Failure; answer_is_no where the
// person left and wants no report.
FalconMeasurement measure_falcon(Falcon& falcon, Operator& person, const FalconCalibration& before);

// For the report, what the measurement itself does not know.
struct MeasurementOrigin {
  std::string version;   // of this program
  std::string when;      // date and time
  std::string firmware;  // file, SHA-256
  bool is_virtual = false;
};

// Markdown, the calibration file's text included.
std::string report_of(const FalconMeasurement& measurement, const MeasurementOrigin& origin);

}  // namespace ghostforce
