// ghostforce doctor --measure: opens the Falcon, has it measured, and writes the report and the calibration. UI thread.
#pragma once

#include <optional>
#include <string>

#include "device/falcon_usb/firmware_file.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/input_catalog.h"

namespace ghostforce {

struct MeasureCall {
  std::optional<FirmwareImage> firmware;
  InputOptions input;
  FtdiLinkOptions cable;
  bool is_virtual = false;
  std::string report = "-";                // path; -: the standard output
  std::optional<std::string> calibration;  // path; none: where calibrations are kept, if the person wants that
};

// Returns the exit code. Throws Failure.
int measure_with_doctor(const MeasureCall& call);

}  // namespace ghostforce
