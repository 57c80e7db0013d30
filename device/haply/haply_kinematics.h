// The kinematics of a pantograph with five bars: two driven links on one base, two distal links that meet at the handle.
// Motor 1 is the origin, motor 2 lies on +x; y points away from the base, towards the person; angles from +x,
// counter-clockwise as seen from above. m, rad, N, N·m. Pure, any thread, never allocates or throws.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/conventions.h"

namespace ghostforce {

struct PantographGeometry {
  double driven_length = 0.07;  // l, both [m]
  double distal_length = 0.09;  // L, both [m]
  double base = 0.038;          // d, from motor 1 to motor 2 [m]

  friend bool operator==(const PantographGeometry&, const PantographGeometry&) = default;
};

struct PantographPose {
  Vector<2> handle{0.0};
  std::array<Vector<2>, 2> elbows{};      // ends of the driven links
  std::array<Vector<2>, 2> directions{};  // along each distal link, from its elbow to the handle [1]
  Matrix<2> jacobian{0.0};                // ∂handle/∂angles: a column for each arm [m/rad]
};

// Where the handle is, on the side of the elbows that is away from the base. Empty: the elbows are too far apart, meet or
// have changed sides, the distal links are in line, or an angle is not finite.
std::optional<PantographPose> pose_at(const PantographGeometry& geometry, const std::array<double, 2>& angles) noexcept;

// The angles of the driven links with both elbows outwards. Empty: out of reach.
std::optional<std::array<double, 2>> angles_at(const PantographGeometry& geometry, const Vector<2>& handle) noexcept;

// The place nearest to `goal` on the way from `center` that the handle reaches with no two links nearly in line. `center`
// is within reach.
Vector<2> nearest_within_reach(const PantographGeometry& geometry, const Vector<2>& center,
                               const Vector<2>& goal) noexcept;

// How far a pose is from one in which two links are parallel: the smallest sine between any two that meet.
double margin_of(const PantographPose& pose, const std::array<double, 2>& angles) noexcept;

// τ = Jᵀ f [N·m].
std::array<double, 2> torques_for(const PantographPose& pose, const Vector<2>& force) noexcept;

// What the handle feels of these torques: f = J⁻ᵀ τ [N]. Empty: the pose is singular.
std::optional<Vector<2>> force_of(const PantographPose& pose, const std::array<double, 2>& torques) noexcept;

// The line along which the motor of arm 0 or 1 can push alone: along its distal link, since the other one, without a
// torque, carries no force. Unit length.
Vector<2> line_of_motor(const PantographPose& pose, std::size_t arm) noexcept;

// Torque of that motor alone over the force that it gives along that line [m].
double lever_of_motor(const PantographPose& pose, std::size_t arm) noexcept;

// Greatest over smallest singular value of J; infinite where it is singular.
double condition_of(const PantographPose& pose) noexcept;

}  // namespace ghostforce
