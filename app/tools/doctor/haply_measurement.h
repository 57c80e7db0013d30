// The measurement of one Haply 2DIY: leads a person through a catalog of steps and gathers what they find. UI thread.
// Written from the published firmware; not tried on a device.
#pragma once

#include <string>
#include <vector>

#include "app/tools/doctor/finding.h"
#include "app/tools/doctor/haply_rig.h"

namespace ghostforce {

struct HaplyMeasurement {
  std::vector<MeasuredStep> steps;
  HaplyCalibration calibration;  // with all that was found
  bool is_complete = false;      // false: the person left before the end and wants the report of what there is

  bool has_all_answers() const { return is_complete && ghostforce::has_all_answers(steps); }
};

// Until the board answers: drives it as the window would, motors off. Throws Failure with the exit code of what is in the
// way.
void await_haply(Haply& haply);

// With a board that answers. Motors are off when it returns or throws, and a board that may push all the same is noted in
// `debts`, which may be null. `before`: what is assumed of this device; what is skipped stays as it is there. Throws
// Failure; answer_is_no where the person left and wants no report.
HaplyMeasurement measure_haply(Haply& haply, HaplyOperator& person, const HaplyCalibration& before, StopDebts* debts);

// For the report, what the measurement itself does not know.
struct HaplyOrigin {
  std::string version;  // of this program
  std::string when;     // date and time
  std::string port;     // which, in words
  bool is_virtual = false;
};

// Markdown, the calibration file's text included.
std::string report_of(const HaplyMeasurement& measurement, const HaplyOrigin& origin);

}  // namespace ghostforce
