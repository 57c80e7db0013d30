// The examination of a Falcon, real or virtual, and the diagnosis: what the examination and a look around the machine
// have found, for people as text and for programs as JSON. UI thread.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/base/failure.h"
#include "device/falcon/falcon_input.h"
#include "device/falcon/falcon_report.h"
#include "device/falcon_usb/firmware_file.h"
#include "device/falcon_usb/usb_search.h"
#include "device/haply_serial/port_search.h"
#include "device/report/spacemouse.h"
#include "device/servo/realtime_status.h"

namespace ghostforce {

// Drives a Falcon as in the window, by the same input, up to the last step that needs no wall, with its motors off all
// the time. Takes seconds; the thread that calls it drives the device.
//
// Looks once whether the device is there, gives it firmware if it has none, waits up to `wait_s` until a person has
// homed it and moved its handle, and measures its exchanges for a second. Ends earlier where a fault ends it. `watch`
// sees every reading and may throw. Returns the last report before the device was let go.
FalconReport examine(FalconInput& falcon, double wait_s, const std::function<void(const FalconReport&)>& watch);

// A renderer that can draw pictures offscreen, or why it cannot.
struct RendererState {
  std::string name;
  bool is_there = false;
  bool is_default = false;
  std::string words;
};

struct Diagnosis {
  FalconReport report;
  ExitCode verdict = ExitCode::done;
  std::optional<FirmwareImage> firmware;
  bool has_calibration = false;               // one is kept for this very device
  UsbSearch usb;                              // what is on the bus
  std::vector<SerialPortFound> serial_ports;  // over USB
  std::filesystem::path udev_rule;            // empty: not installed
  RealtimeStatus realtime;
  SpaceMouseReading spacemouse;
  std::vector<RendererState> renderers;
};

// One line for a person: which file, its SHA-256, and what that is commonly called.
std::string firmware_words(const std::optional<FirmwareImage>& image);

std::string text_of(const Diagnosis& diagnosis);
std::string json_of(const Diagnosis& diagnosis);

}  // namespace ghostforce
