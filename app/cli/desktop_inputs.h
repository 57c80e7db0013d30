// The inputs of the desktop: those of every system, and the hardware; what --input, the panel Input and `doctor` know.
// With the options of the command line that are about a Falcon. Any thread, but for FalconSetUp: UI thread. Making an
// input allocates and may throw.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/cli/overwrite_guard.h"
#include "app/shell/input_link.h"
#include "device/falcon_usb/firmware_file.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/report/motor_report.h"

namespace ghostforce {

class FalconInput;

// A Falcon on this cable.
InputMaker<FalconInput> falcon_kind(const FtdiLinkOptions& cable);

// In the order in which people see them.
std::vector<InputEntry> desktop_inputs(const FtdiLinkOptions& cable = {});

// Without the hardware.
std::vector<InputEntry> simulated_inputs();

// How a run of the window ended, as far as the input's device is concerned. Pure.
// `readiness`: of the input, empty where it has none; `of_input`: what its link says.
EndOfRun end_of_run(const MotorReport& motors, std::span<const ReadinessStepState> readiness, const EndOfRun& of_input);

// The options of the command line that are about a Falcon, and what they make of the files that it needs. Shared by the
// commands that drive one.
struct FalconSetUp {
  std::string firmware;                // path; empty: where it usually is, see firmware_path()
  std::string usb_id;                  // VVVV:PPPP; empty: that of every Falcon
  std::string serial;                  // of the one that is meant; empty: the first, in their order
  std::vector<std::string> misbehave;  // names of injected_fault_catalog()

  void attach(CLI::App& command, FileOptions& files);

  // Throws Failure(wrong_call) where faults are asked of another input than the virtual Falcon.
  void refuse_misbehaviour_of_others(std::string_view input) const;

  // Empty: no file is named and none is in the usual place. Throws Failure where there is one and it cannot be taken.
  std::optional<FirmwareImage> read_firmware_file() const;

  // With the calibrations that are kept. Throws Failure where one of them is wrong.
  InputOptions input_options(const std::optional<FirmwareImage>& image) const;

  // Which Falcon is meant.
  FtdiLinkOptions cable() const;
};

}  // namespace ghostforce
