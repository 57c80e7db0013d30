// ghostforce doctor --measure: opens the Falcon, has it measured by a person at the terminal, and writes the report and
// the calibration. UI thread.
#pragma once

#include <optional>
#include <string>

#include "app/tools/doctor/rig.h"
#include "app/tools/doctor/terminal_operator.h"
#include "device/falcon/falcon.h"
#include "device/falcon_usb/firmware_file.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/virtual_falcon/injected_fault.h"
#include "device/virtual_falcon/measured_person.h"

namespace ghostforce {

struct MeasureCall {
  std::optional<FirmwareImage> firmware;
  FalconOptions falcon;
  InjectedFault injected_fault;  // of the virtual Falcon
  FtdiLinkOptions cable;
  bool is_virtual = false;
  std::string report = "-";                // path; -: the standard output
  std::optional<std::string> calibration;  // path; none: where calibrations are kept, if the person wants that
};

// Returns the exit code. Throws Failure.
int measure_with_doctor(const MeasureCall& call);

using TerminalOperator = TerminalOperatorFor<OperatorAction, MeasuredPerson>;

}  // namespace ghostforce
