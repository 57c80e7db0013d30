// FalconCalibration: what is true of one particular Falcon, and how its handle is laid over the wall's plane. The
// defaults serve a device of which nothing is known. Pure values, any thread, never allocate or throw.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/conventions.h"
#include "device/falcon/geometry.h"

namespace ghostforce {

// The number by which a device is told from others of its kind; 8 letters in all that were seen.
class FalconSerial {
 public:
  static constexpr std::size_t longest = 31;

  FalconSerial() = default;

  // Empty: too long.
  static constexpr std::optional<FalconSerial> from(std::string_view text) noexcept {
    if (text.size() > longest) return std::nullopt;
    FalconSerial serial;
    std::copy(text.begin(), text.end(), serial.letters_.begin());
    serial.size_ = static_cast<std::uint8_t>(text.size());
    return serial;
  }

  constexpr std::string_view text() const noexcept { return {letters_.data(), size_}; }

  friend bool operator==(const FalconSerial&, const FalconSerial&) = default;

 private:
  std::array<char, longest> letters_{};
  std::uint8_t size_ = 0;
};

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

// Whether they are the same line, whatever their sense: no plane lies between such two.
constexpr bool are_parallel(FalconAxis a, FalconAxis b) noexcept {
  return static_cast<std::uint8_t>(a) / 2 == static_cast<std::uint8_t>(b) / 2;
}

struct FalconCalibration {
  FalconSerial serial;  // empty: of any device
  FalconGeometry geometry;
  double counts_per_newton_metre = measured_motor_constant;
  MotorNumbers encoder_offset{};          // added to what the encoders say [counts]
  Vector<3> center{0.0, 0.0, 0.125};      // of the workspace; the middle of the wall's plane [m]
  FalconAxis right_axis = FalconAxis::x;  // right and up on the wall; the third axis is free
  FalconAxis up_axis = FalconAxis::y;
  double scale = 1.0;  // metres on the wall per metre of the handle

  friend bool operator==(const FalconCalibration&, const FalconCalibration&) = default;
};

// Of the upper arms, from what the encoders say.
inline Vector<3> joint_angles(const MotorNumbers& encoders, const FalconCalibration& calibration) noexcept {
  Vector<3> counts;
  for (std::size_t i = 0; i < encoders.size(); ++i) {
    counts[static_cast<glm::length_t>(i)] = encoders[i] + calibration.encoder_offset[i];
  }
  return angles_of_counts(counts, calibration.geometry);
}

}  // namespace ghostforce
