// FalconGeometry: the lengths and angles of the Falcon's three legs, and what one encoder count is worth. Two people
// took different lengths from different devices and nobody has settled which are truer: hence a catalog of named sets.
// Lengths in m, angles in rad. Pure values, any thread, never allocate or throw.
//
// A leg is a motor at the base, an upper arm that it swings, and a parallelogram from the arm's end to the handle's
// plate. Radial is away from the base's axis in the direction of the leg's azimuth, tangential is 90° counter-clockwise
// of that. The letters are those of the published kinematics (Stamper; Martin & Hillier).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/conventions.h"

namespace ghostforce {

// One 16-bit number per motor, as frames carry them.
using MotorNumbers = std::array<std::int16_t, 3>;

constexpr Vector<3> vector_of(const MotorNumbers& numbers) noexcept {
  return {numbers[0], numbers[1], numbers[2]};
}

struct FalconGeometry {
  double upper_arm = 0.060;             // a: from the motor's axis to the parallelogram
  double parallelogram = 0.1025;        // b: its long side
  double effector_radial = 0.01443;     // c: from the handle's middle to where a leg ends
  double near_link = 0.01125;           // d: the parallelogram's short sides, at the arm
  double far_link = 0.01125;            // e: and at the handle
  double effector_tangential = -0.025;  // f
  double base_radial = 0.040;           // r: from the base's middle to the motor's axis
  double base_tangential = -0.02309;    // s
  std::array<double, 3> azimuths{105.0 * radians_per_degree, -15.0 * radians_per_degree, -135.0 * radians_per_degree};
  double counts_per_motor_turn = 1280.0;
  double gear_ratio = 110.0 / 14.25;                       // turns of the motor per turn of the upper arm
  double angle_at_zero_count = 35.0 * radians_per_degree;  // of every upper arm, just homed

  friend bool operator==(const FalconGeometry&, const FalconGeometry&) = default;
};

struct GeometryPreset {
  std::string_view name;      // in files
  std::string_view sentence;  // where the numbers come from, for a person
  FalconGeometry geometry;
};

// The first one is the default.
std::span<const GeometryPreset> geometry_catalog() noexcept;

// Of the upper arm.
double radians_per_count(const FalconGeometry& geometry) noexcept;

// Counts need not be whole: whoever has an offset adds it first.
Vector<3> angles_of_counts(const Vector<3>& counts, const FalconGeometry& geometry) noexcept;
Vector<3> counts_of_angles(const Vector<3>& angles, const FalconGeometry& geometry) noexcept;

}  // namespace ghostforce
