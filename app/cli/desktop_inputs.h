// The inputs of the desktop: those of every system, and the hardware; what --input, the panel Input and `doctor` know.
// With the options of the command line that are about devices with motors. Any thread, but for DeviceSetUp: UI thread.
// Making an input allocates and may throw.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/cli/overwrite_guard.h"
#include "app/shell/input_link.h"
#include "device/falcon_usb/firmware_file.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/haply_serial/tty_port.h"
#include "device/report/motor_report.h"

namespace ghostforce {

class FalconInput;
class HaplyInput;
class VirtualHaplyInput;

// Which devices are meant.
struct Cables {
  FtdiLinkOptions falcon{};
  TtyPortOptions haply{};
};

// A Falcon, and a Haply, on these cables.
InputMaker<FalconInput> falcon_kind(const FtdiLinkOptions& cable);
InputMaker<HaplyInput> haply_kind(const TtyPortOptions& port);
extern const InputMaker<VirtualHaplyInput> virtual_haply_kind;

// In the order in which people see them.
std::vector<InputEntry> desktop_inputs(const Cables& cables = {});

// Without the hardware.
std::vector<InputEntry> simulated_inputs();

// How a run of the window ended, as far as the input's device is concerned. Pure.
// `readiness`: of the input, empty where it has none; `of_input`: what its link says.
EndOfRun end_of_run(const MotorReport& motors, std::span<const ReadinessStepState> readiness, const EndOfRun& of_input);

// The options of the command line that are about devices with motors, and what they make of the files that those need.
// Shared by the commands that drive one.
struct DeviceSetUp {
  std::string haply_port;              // path; empty: that of the only known board
  std::string haply_variant;           // a name of haply_variant_catalog(); empty: the usual one
  std::string firmware;                // path; empty: where it usually is, see firmware_path()
  std::string usb_id;                  // VVVV:PPPP; empty: that of every Falcon
  std::string serial;                  // of the one that is meant; empty: the first, in their order
  std::vector<std::string> misbehave;  // names of injected_fault_catalog() or injected_haply_fault_catalog()

  void attach(CLI::App& command, FileOptions& files);

  // Throws Failure(wrong_call) where faults are asked of an input that is not simulated, or that has none of that name.
  void refuse_misbehaviour_of_others(std::string_view input) const;

  // Empty: no file is named and none is in the usual place. Throws Failure where there is one and it cannot be taken.
  std::optional<FirmwareImage> read_firmware_file() const;

  // With the calibrations that are kept. Throws Failure where one of them is wrong.
  InputOptions input_options(const std::optional<FirmwareImage>& image) const;

  Cables cables() const;
};

}  // namespace ghostforce
