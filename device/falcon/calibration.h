// FalconCalibration: what is true of one particular Falcon, and how its workspace maps to the plane of the wall. The
// defaults are for a device of which nothing is known. Pure values, any thread, never allocate or throw.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/conventions.h"
#include "device/falcon/kinematics.h"
#include "device/motors/device_serial.h"

namespace ghostforce {

// Motor counts per N·m at an upper arm. Three were published and they disagree: from captures of the vendor's driver,
// from Martin & Hillier's measurement of the motors, and from libnifalcon's comparison with the vendor's driver
// (10000). Only the second was measured as a torque. A device whose true number is smaller pushes harder than it was
// asked to, so limits of force are held with the smallest.
inline constexpr double smallest_published_motor_constant = 3530.0;
inline constexpr double measured_motor_constant = 6600.0;

// A direction of the device: x right, y up, z out towards the user.
enum class FalconAxis : std::uint8_t { x, minus_x, y, minus_y, z, minus_z };

constexpr Vector<3> direction_of(FalconAxis axis) noexcept {
  const auto number = static_cast<std::uint8_t>(axis);
  Vector<3> direction(0.0);
  direction[number / 2] = number % 2 == 0 ? 1.0 : -1.0;
  return direction;
}

// Whether they are the same line, whatever their sense: two such axes do not span a plane.
constexpr bool are_parallel(FalconAxis a, FalconAxis b) noexcept {
  return static_cast<std::uint8_t>(a) / 2 == static_cast<std::uint8_t>(b) / 2;
}

// Which of a frame's three numbers belongs to the first, second and third leg, counted from 1; below 0: that number
// counts, or pulls, the other way. Legs are those of the geometry's azimuths.
using LegNumbers = std::array<std::int8_t, 3>;
inline constexpr LegNumbers legs_in_order{1, 2, 3};

// Each of the three once.
constexpr bool are_leg_numbers(const LegNumbers& numbers) noexcept {
  unsigned seen = 0;
  for (const int number : numbers) {
    if (number < -3 || number > 3) return false;
    seen |= 1U << static_cast<unsigned>(number < 0 ? -number : number);
  }
  return seen == 0b1110U;
}

constexpr std::size_t place_in_frame(std::int8_t number) noexcept {
  return static_cast<std::size_t>(number < 0 ? -number : number) - 1;
}
constexpr int sign_of(std::int8_t number) noexcept {
  return number < 0 ? -1 : 1;
}

// Leg by leg, from three numbers in a frame's order.
inline Vector<3> in_leg_order(const Vector<3>& frame, const LegNumbers& number_of_leg) noexcept {
  Vector<3> legs;
  for (glm::length_t leg = 0; leg < 3; ++leg) {
    const std::int8_t number = number_of_leg[static_cast<std::size_t>(leg)];
    legs[leg] = sign_of(number) * frame[static_cast<glm::length_t>(place_in_frame(number))];
  }
  return legs;
}

// The middle of a handle's workspace, where no calibration has another one [m].
inline constexpr Vector<3> workspace_center{0.0, 0.0, 0.125};

struct FalconCalibration {
  DeviceSerial serial;  // empty: of any device
  FalconGeometry geometry;
  double counts_per_newton_metre = measured_motor_constant;
  Vector<3> motor_strengths{1.0};  // of each leg's motor: its torque per count beside that of the constant above
  LegNumbers motor_of_leg = legs_in_order;
  LegNumbers encoder_of_leg = legs_in_order;
  MotorNumbers encoder_offset{};          // added to what the encoders say, in a frame's order [counts]
  Vector<3> center = workspace_center;    // the middle of the wall's plane [m]
  FalconAxis right_axis = FalconAxis::x;  // right and up on the wall; the third axis is free
  FalconAxis up_axis = FalconAxis::y;
  double scale = 1.0;  // metres on the wall per metre of the handle

  friend bool operator==(const FalconCalibration&, const FalconCalibration&) = default;
};

// The one of this device; the default where there is none.
inline FalconCalibration calibration_of(const DeviceSerial& serial,
                                        std::span<const FalconCalibration> calibrations) noexcept {
  const auto known = std::ranges::find(calibrations, serial, &FalconCalibration::serial);
  return known == calibrations.end() ? FalconCalibration{} : *known;
}

// Leg by leg, from the geometry's zero, from what the encoders say in a frame; means of several need not be whole.
inline Vector<3> leg_counts(const Vector<3>& encoders, const FalconCalibration& calibration) noexcept {
  return in_leg_order(encoders + vector_of(calibration.encoder_offset), calibration.encoder_of_leg);
}

// Of the upper arms, from what the encoders say.
inline Vector<3> joint_angles(const MotorNumbers& encoders, const FalconCalibration& calibration) noexcept {
  return angles_of_counts(leg_counts(vector_of(encoders), calibration), calibration.geometry);
}

// As a frame carries them, from motor counts leg by leg.
constexpr MotorNumbers in_frame_order(const MotorNumbers& of_legs, const LegNumbers& motor_of_leg) noexcept {
  MotorNumbers frame{};
  for (std::size_t leg = 0; leg < of_legs.size(); ++leg) {
    frame[place_in_frame(motor_of_leg[leg])] = static_cast<std::int16_t>(sign_of(motor_of_leg[leg]) * of_legs[leg]);
  }
  return frame;
}

// Of each leg's motor [counts per N·m].
inline Vector<3> motor_constants(const FalconCalibration& calibration) noexcept {
  return calibration.counts_per_newton_metre / calibration.motor_strengths;
}

// What a frame must carry so that the handle pushes with `force`, as motor_counts() has it; zeros where it cannot.
inline MotorNumbers motor_numbers(const Vector<3>& force, const Matrix<3>& jacobian,
                                  const FalconCalibration& calibration) noexcept {
  return in_frame_order(motor_counts(force, jacobian, motor_constants(calibration)).counts, calibration.motor_of_leg);
}

}  // namespace ghostforce
