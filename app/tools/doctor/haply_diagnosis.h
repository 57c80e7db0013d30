// The examination of a Haply 2DIY, real or virtual, and the diagnosis: what the examination and a look at the serial ports
// have found, for people as text and for programs as JSON. UI thread.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/base/failure.h"
#include "device/haply/haply_input.h"
#include "device/haply/haply_report.h"
#include "device/haply_serial/port_search.h"
#include "device/motors/device_serial.h"
#include "device/servo/realtime_status.h"

namespace ghostforce {

// Drives a board as in the window, up to where a person would have to confirm the zero pose, with zero torques all the
// time; measures its exchanges for a second. Ends earlier where a fault ends it. Takes seconds; the thread that calls it
// drives the device. `watch` sees every reading and may throw. Returns the last report before the board was let go.
HaplyReport examine(HaplyInput& haply, const std::function<void(const HaplyReport&)>& watch);

struct HaplyDiagnosis {
  HaplyReport report;
  ExitCode verdict = ExitCode::done;
  // What the calibration that is kept and used is about, an empty one: any board. Empty: none is kept.
  std::optional<DeviceSerial> calibrated_board{};
  std::vector<SerialPortFound> ports;  // over USB
  std::filesystem::path udev_rule;     // empty: not installed
  RealtimeStatus realtime;
};

std::string text_of(const HaplyDiagnosis& diagnosis);
std::string json_of(const HaplyDiagnosis& diagnosis);

}  // namespace ghostforce
