// Calibrations of devices as files, what those of all kinds of device share: one TOML file each in a folder of the settings'
// folder (app/files/xdg_folders.h), each about the device whose serial number it says. UI thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

#include "app/files/toml_document.h"
#include "device/motors/device_serial.h"

namespace ghostforce {

// What a file says about one kind of device is read by this, and kept by whoever gave it: returns which device it is
// about. Throws ReadError.
using ReadCalibration = std::function<DeviceSerial(std::string_view text, std::string_view shown_path)>;

struct CalibrationFile {
  std::filesystem::path path;
  DeviceSerial serial;
};

// Hands all files in the settings' folder of this name to `read`, in the order of their names. Where there is no folder
// there are none. Throws ReadError: wrong with every problem of every file, also where two files are about the same
// device; unreadable.
std::vector<CalibrationFile> read_calibrations(std::string_view folder, const ReadCalibration& read);

// Writes the file that is about the device, or else NAME.toml, whole or not at all; returns its path. Throws
// Failure(file_trouble) and ReadError, as above.
std::filesystem::path save_calibration(std::string_view folder, const DeviceSerial& serial, std::string_view name,
                                       std::string_view text, const ReadCalibration& read);

// One that can be part of a file's name.
bool is_serial(std::string_view text) noexcept;
// As a person gives it to save by. Throws Failure(wrong_call) where it is no such number.
void expect_serial(std::string_view text);

// What reads the key serial.
std::function<void(const TomlValue&)> serial_into(DeviceSerial& serial);

}  // namespace ghostforce
