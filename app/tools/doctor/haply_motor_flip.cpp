#include "app/tools/doctor/haply_motor_flip.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/haply_calibration_file.h"

namespace ghostforce {

DeviceSerial serial_of_board(const std::string& path, std::span<const SerialPortFound> ports) {
  std::error_code error;
  if (!path.empty()) {
    const std::filesystem::path node = std::filesystem::canonical(path, error);
    if (error) {
      throw Failure(ExitCode::device_absent,
                    fmt::format("{} is not there; plug the board in, or name another port with --haply-port",
                                quoted_text(path, longest_path)));
    }
    const SerialPortFound* const port = find_port(ports, node.string());
    return port == nullptr ? DeviceSerial() : device_serial_of(port->serial);
  }
  const auto is_known = [](const SerialPortFound& port) { return !port.board.empty(); };
  const auto count = std::ranges::count_if(ports, is_known);
  if (count == 1) return device_serial_of(std::ranges::find_if(ports, is_known)->serial);
  throw Failure(ExitCode::device_absent,
                count == 0 ? "no board is plugged in that is known; plug it in, or name its port with --haply-port"
                           : "several boards are plugged in; name the port of the one that you mean with --haply-port");
}

HaplyCalibration with_flipped_motor(const DeviceSerial& serial, std::span<const HaplyCalibration> calibrations,
                                    std::string_view variant, std::size_t motor) {
  const auto find = [&](const DeviceSerial& number) {
    return std::ranges::find(calibrations, number, &HaplyCalibration::serial);
  };
  auto kept = find(serial);
  if (kept == calibrations.end()) kept = find(DeviceSerial());
  if (kept == calibrations.end() && variant.empty()) {
    throw Failure(ExitCode::wrong_call,
                  fmt::format("there is no calibration file for this board yet, and what is written now counts from "
                              "then on; say which Haply it is: --haply-variant {}",
                              listed(names_of(haply_variant_catalog()))));
  }
  HaplyCalibration calibration = kept != calibrations.end() ? *kept : find_haply_variant(variant)->calibration;
  // What was known of any board is known of this one now.
  calibration.serial = serial;
  bool& is_reversed = calibration.arms.at(motor).is_motor_reversed;
  is_reversed = !is_reversed;
  return calibration;
}

std::string flip_haply_motor(const HaplyMotorFlip& flip) {
  const DeviceSerial serial = serial_of_board(flip.port, flip.ports);
  const HaplyCalibration calibration = with_flipped_motor(serial, flip.calibrations, flip.variant, flip.motor);
  const std::filesystem::path path = save_haply_calibration(calibration);
  return fmt::format(
      "Motor {} of the {} now has the other sign: motor_reversed = {} under [arm{}] in {}.\nStart the program again. "
      "When you arm the motors, the direction test looks whether it is right now.\n",
      flip.motor + 1, find_haply_variant(calibration.variant)->title, calibration.arms[flip.motor].is_motor_reversed,
      flip.motor + 1, quoted_text(path.string(), longest_path));
}

}  // namespace ghostforce
