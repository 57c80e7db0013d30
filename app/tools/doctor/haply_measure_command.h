// ghostforce doctor haply --measure: opens a Haply 2DIY, has it measured by a person at the terminal, and writes the report
// and the calibration. UI thread.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/tools/doctor/haply_rig.h"
#include "app/tools/doctor/terminal_operator.h"
#include "device/haply/haply.h"
#include "device/haply/serial_port.h"
#include "device/virtual_haply/haply_fault.h"
#include "device/virtual_haply/measured_haply_person.h"

namespace ghostforce {

struct HaplyMeasureCall {
  std::unique_ptr<SerialPort> port;  // null: a rehearsal, on a simulated board of the usual variant
  std::string port_words;            // which port, for the report; as "/dev/ttyACM0"
  HaplyOptions haply;
  InjectedHaplyFault injected_fault;       // of the simulated board
  std::string report = "-";                // path; -: the standard output
  std::optional<std::string> calibration;  // path; none: where calibrations are kept, if the person wants that
};

// Returns the exit code. Throws Failure.
int measure_haply_with_doctor(HaplyMeasureCall call);

using TerminalHaplyOperator = TerminalOperatorFor<HaplyAction, MeasuredHaplyPerson>;

}  // namespace ghostforce
