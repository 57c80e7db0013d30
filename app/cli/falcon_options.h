// FalconSetUp: the options of the command line that are about a Falcon, and what they make of the files that it needs.
// Shared by the commands that drive one. UI thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/overwrite_guard.h"
#include "device/falcon_usb/firmware_file.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/input_catalog.h"

namespace ghostforce {

struct FalconSetUp {
  std::string firmware;                // path; empty: where it usually is, see firmware_path()
  std::string usb_id;                  // VVVV:PPPP; empty: that of every Falcon
  std::string serial;                  // of the one that is meant; empty: the first, in their order
  std::vector<std::string> misbehave;  // names of injected_fault_catalog()

  void attach(CLI::App& command, FileOptions& files);

  // Empty: no file is named and none is in the usual place. Throws Failure where there is one and it cannot be taken.
  std::optional<FirmwareImage> read_firmware_file() const;

  // With the calibrations that are kept. Throws Failure where one of them is wrong.
  InputOptions input_options(const std::optional<FirmwareImage>& image) const;

  // Which Falcon is meant.
  FtdiLinkOptions cable() const;
};

}  // namespace ghostforce
