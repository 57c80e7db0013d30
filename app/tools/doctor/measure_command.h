// ghostforce doctor --measure: opens the Falcon, has it measured by a person at the terminal, and writes the report and
// the calibration. UI thread.
#pragma once

#include <optional>
#include <string>

#include "app/tools/doctor/rig.h"
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

// A person at a terminal, or a file of answers: words go to the error output, lines come from the standard input. In a
// rehearsal a simulated person does what is asked, and answers where the line is empty.
class TerminalOperator final : public Operator {
 public:
  // Null: the device is real. Else it must live as long as this.
  explicit TerminalOperator(MeasuredPerson* simulated) : simulated_(simulated) {}

  void tell(std::string_view words) override;
  std::optional<std::string> ask(const OperatorAction& action, std::string_view words) override;
  void cue(const OperatorAction& action) override;

 private:
  MeasuredPerson* simulated_;
};

}  // namespace ghostforce
