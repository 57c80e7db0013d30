// Calibrations of Falcons, one TOML file each in falcon/ of the settings' folder (app/files/xdg_folders.h). Strict,
// as scenes are: whatever is not known, of the wrong type or out of range is told with file, line and column, all of it
// at once. UI thread.
//
//     format = 1
//     serial = "12PZ657E"                        # all else is optional
//     geometry = "libnifalcon"                   # a name of geometry_catalog()
//     motor_constant_counts_per_N_m = 6600.0     # 1000 to 100000
//     motor_strengths = [1.0, 1.0, 1.0]          # 0.2 to 2 each, leg by leg
//     motor_of_leg = [1, 2, 3]                   # each of 1, 2, 3 once, each with a minus or not
//     encoder_of_leg = [1, 2, 3]                 # the same
//     angle_at_zero_count_deg = 35.0             # -90 to 90; else the geometry's
//     gear_ratio = 7.719                         # 6 to 10; else the geometry's
//     encoder_offset_counts = [0, 0, 0]          # whole, -4096 to 4096 each
//     center_mm = [0.0, 0.0, 125.0]              # -200 to 200 each
//     right_axis = "x"                           # x, -x, y, -y, z, -z
//     up_axis = "y"                              # not along the same line
//     scale = 1.0                                # 0.1 to 10
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/read_error.h"
#include "device/falcon/calibration.h"

namespace ghostforce {

// `shown_path` is what messages call the file. Throws ReadError(wrong), one line per problem:
//     FILE:LINE:COLUMN: the key KEY: what is wrong; what to do
FalconCalibration read_falcon_calibration(std::string_view text, std::string_view shown_path);

// The calibration as a file. Reads back to the same values but for the last digit of an angle or a length. The geometry
// must be one of the catalog, whatever its angle at count zero and its gear; else Failure(bug).
std::string falcon_calibration_text(const FalconCalibration& calibration);

// All of them, in the order of their files' names. Where there is no folder there are none. Throws ReadError: wrong
// with every problem of every file, also where two files are about the same device; unreadable.
std::vector<FalconCalibration> load_falcon_calibrations();

// Into the file that is about the device, or else SERIAL.toml, whole or not at all; returns its path. Throws Failure:
// wrong_call where the serial number is empty or no name of a file; file_trouble. And ReadError, as above.
std::filesystem::path save_falcon_calibration(const FalconCalibration& calibration);

}  // namespace ghostforce
