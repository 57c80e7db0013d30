// HaplyCalibration: what is true of one particular Haply 2DIY, and how its workspace maps to the plane of the wall. The
// variants are the published ones; nobody has measured them on a device for this program. Pure values, any thread, never
// allocate or throw. SI units; angles in degrees where the board has them so.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/conventions.h"
#include "device/haply/hapi.h"
#include "device/haply/haply_kinematics.h"
#include "device/motors/device_serial.h"

namespace ghostforce {

// Motor and encoder of one arm. Arm 1 is the one whose axis is the origin.
struct HaplyArm {
  std::uint8_t motor_port = 1;       // 1 or 2, where its motor is plugged in
  std::uint8_t motor_direction = 0;  // as hAPI has it: 0 clockwise, 1 counter-clockwise
  std::uint8_t encoder_port = 1;
  std::uint8_t encoder_direction = 0;
  double offset_deg = 0.0;          // the arm's angle in the zero pose
  double counts_per_turn = 4880.0;  // of the encoder, as the board is told
  bool is_motor_reversed = false;   // it pushes against its arm's angle: the driver sends the other sign
  double torque_scale = 1.0;        // N·m at the arm for each N·m that is sent, as measured

  friend bool operator==(const HaplyArm&, const HaplyArm&) = default;
};

struct HaplyCalibration {
  DeviceSerial serial;       // of the board; empty: of any
  std::string_view variant;  // a name of haply_variant_catalog(), whose text it is
  PantographGeometry geometry;
  std::array<HaplyArm, 2> arms{};
  Vector<2> center{0.0};  // of the workspace, the middle of the wall's plane, in the device's frame [m]
  double scale = 1.0;     // metres on the wall per metre of the handle

  friend bool operator==(const HaplyCalibration&, const HaplyCalibration&) = default;
};

// What the board is told of it.
hapi::SetUp set_up_of(const HaplyCalibration& calibration) noexcept;
// Angles of the arms in the zero pose [rad].
std::array<double, 2> zero_pose_of(const HaplyCalibration& calibration) noexcept;

struct HaplyVariant {
  std::string_view name;       // on the command line and in files
  std::string_view title;      // for people
  std::string_view zero_pose;  // how to hold the arms while the zero pose is confirmed, as a sentence
  HaplyCalibration calibration;
};

// In the order of their years. The last one is the default.
std::span<const HaplyVariant> haply_variant_catalog() noexcept;
const HaplyVariant& usual_haply_variant() noexcept;
// Null when none has that name.
const HaplyVariant* find_haply_variant(std::string_view name) noexcept;

// The one of this board; where there is none, `usual`, which is then that of any board.
HaplyCalibration calibration_of(const DeviceSerial& serial, std::span<const HaplyCalibration> calibrations,
                                const HaplyCalibration& usual) noexcept;

}  // namespace ghostforce
