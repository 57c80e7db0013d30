// Calibrations of Haply 2DIYs, one TOML file each in haply/ of the settings' folder (app/files/xdg_folders.h). Strict, as
// scenes are: whatever is not known, of the wrong type or out of range is told with file, line and column, all of it at
// once. UI thread.
//
//     format = 1
//     variant = "v3.1"                           # a name of haply_variant_catalog(): 2017, v2, v3, v3.1
//     serial = "9A2D6C5150304D4B372E3120FF0A1D2B" # of the board; without it: any board. All else is optional, too, and as
//                                                # the variant has it
//     [geometry]
//     driven_mm = 70.0                           # 10 to 500
//     distal_mm = 90.0                           # 10 to 500
//     base_mm = 38.0                             # 0 to 500
//
//     [arm1]                                     # whose axis is the origin; and [arm2]
//     motor_port = 2                             # 1 or 2, another one for each arm
//     motor_direction = "counter-clockwise"      # or "clockwise", as hAPI has it
//     encoder_port = 2                           # as the motor's
//     encoder_direction = "counter-clockwise"
//     offset_deg = 168.0                         # -360 to 360, the arm's angle in the zero pose
//     counts_per_turn = 4880.0                   # 100 to 200000
//     motor_reversed = false                     # it pushes against its arm's angle
//     torque_scale = 1.0                         # 0.1 to 10, N·m at the arm for each N·m that is sent
//
//     [plane]
//     center_mm = [19.0, 90.0]                   # -500 to 500 each
//     scale = 1.0                                # 0.1 to 20
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/files/read_error.h"
#include "device/haply/haply_calibration.h"

namespace ghostforce {

// `shown_path` is what messages call the file. Throws ReadError(wrong), one line per problem:
//     FILE:LINE:COLUMN: the key TABLE.KEY: what is wrong; what to do
HaplyCalibration read_haply_calibration(std::string_view text, std::string_view shown_path);

// The calibration as a file. Reads back to the same values but for what is beyond the twelfth digit. The variant must be
// one of the catalog; else Failure(bug).
std::string haply_calibration_text(const HaplyCalibration& calibration);

// All of them, in the order of their files' names. Where there is no folder there are none. Throws ReadError: wrong
// with every problem of every file, also where two files are about the same board; unreadable.
std::vector<HaplyCalibration> load_haply_calibrations();

// Into the file that is about the board, or else SERIAL.toml, or any.toml where it is about any board, whole or not at
// all; returns its path. Throws Failure: wrong_call where the serial number is no name of a file; file_trouble. And
// ReadError, as above.
std::filesystem::path save_haply_calibration(const HaplyCalibration& calibration);

}  // namespace ghostforce
