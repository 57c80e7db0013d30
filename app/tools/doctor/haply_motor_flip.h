// `doctor haply --flip-motor`: turns round the sign of one motor in the calibration file of the board that is plugged in,
// where the check of the motors has found that it pushes the wrong way. The board itself is not spoken to, so that another
// program may have its port. UI thread; throws Failure and ReadError.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "device/haply/haply_calibration.h"
#include "device/haply_serial/port_search.h"

namespace ghostforce {

// The board at `path`; where that is empty, the only one that is known. Empty: it has no serial number. Throws
// Failure(device_absent) where it is not there, or nobody can tell which one is meant.
DeviceSerial serial_of_board(const std::string& path, std::span<const SerialPortFound> ports);

// What is known of the board, with the sign of this motor (0 or 1) the other way round. `variant`: what the person calls
// it; empty: nothing was said. Throws Failure(wrong_call) where no file is about the board and nothing was said: a file
// with a guess would count from then on.
HaplyCalibration with_flipped_motor(const DeviceSerial& serial, std::span<const HaplyCalibration> calibrations,
                                    std::string_view variant, std::size_t motor);

struct HaplyMotorFlip {
  std::size_t motor = 0;  // 0 or 1
  std::string port{};     // path; empty: that of the only known board
  std::string variant{};  // as above
  std::vector<SerialPortFound> ports{};
  std::vector<HaplyCalibration> calibrations{};
};

// Does it, and returns what was done, as sentences.
std::string flip_haply_motor(const HaplyMotorFlip& flip);

}  // namespace ghostforce
