// FalconKinematics: from the position of the handle to the angles of the three upper arms, and back; and from a force
// at the handle to what the motors must do. Exact for a geometry (geometry.h); how well that describes a device is
// another question. x right, y up, z out of the device towards the user; m, rad, N, N·m, from the middle of the base.
// Made for the servo thread: never allocates or throws, and every call ends within a bounded number of steps.
#pragma once

#include <array>
#include <optional>

#include "core/conventions.h"
#include "device/falcon/geometry.h"

namespace ghostforce {

// Where the search for a position begins when nothing is known: inside the workspace, where every leg is bent.
inline constexpr Vector<3> cold_start{0.0, 0.0, 0.11};

struct ForwardKinematics {
  Vector<3> position;          // the nearest that was found if it has not converged
  int iterations = 0;          // steps of the search
  bool has_converged = false;  // false: no position of the handle has these angles, or none could be found
};

class FalconKinematics {
 public:
  explicit FalconKinematics(const FalconGeometry& geometry) noexcept;

  // The upper arms' angles at a position, in (−π, π]; 0 is level, grows outwards. Empty: out of reach, or not finite.
  std::optional<Vector<3>> angles(const Vector<3>& position) const noexcept;

  // A = ∂angles/∂position [rad/m], row per leg. Empty: out of reach, or a leg is at the end of its reach.
  std::optional<Matrix<3>> jacobian(const Vector<3>& position) const noexcept;

  // The position that has these angles, by Newton's method from `start`, which should be the last known position, and
  // from the cold start if that leads nowhere. Three arms can hold a handle on either side of their knees; this finds
  // the position on the side where a Falcon's handle is.
  ForwardKinematics position(const Vector<3>& angles, const Vector<3>& start = cold_start) const noexcept;

 private:
  struct Azimuth {
    double cosine;
    double sine;
  };

  // Where a leg ends, from its motor's axis, and what that leaves of the triangle in the plane in which the upper arm
  // swings: arm, parallelogram, and the line from the axis to the end.
  struct Leg {
    double radial;      // [m]
    double tangential;  // [m]
    double height;      // of the parallelogram, in that plane [m]
    double length;      // of the parallelogram with its short sides, in that plane [m]
    double cosine;      // of the corner between arm and line, times twice the product of both [m²]
    double sine;        // and its sine, times the same: four times the triangle's area [m²]
  };

  Leg leg_ending_at(const Vector<3>& position, const Azimuth& azimuth) const noexcept;

  // One leg that ends at a position while its upper arm is where an angle puts it: from the knee to its end.
  struct Gap {
    double radial;       // [m]
    double height;       // of the parallelogram, in the plane in which the upper arm swings [m]
    double length;       // of the same with its short sides [m]
    double z;            // [m]
    double size;         // by which the parallelogram is too short, to first order, times its long side [m²]
    Vector<3> gradient;  // of that, times `length`: the parallelogram's direction, once the gap is closed [m²]
    bool is_bent_right;  // the knee is on the outer side, and the parallelogram points away from it
  };
  struct Arms {
    Vector<3> cosines;
    Vector<3> sines;
  };
  using Gaps = std::array<Gap, 3>;

  bool measure(const Vector<3>& position, const Arms& arms, Gaps& gaps) const noexcept;
  Vector<3> bends(const Gaps& gaps, const Vector<3>& step) const noexcept;
  ForwardKinematics search(const Arms& arms, const Vector<3>& start) const noexcept;

  FalconGeometry geometry_;
  std::array<Azimuth, 3> azimuths_;
  double handedness_ = 0.0;  // the sign of the parallelograms' triple product wherever a handle can be
};

// The greatest number that a motor is sent, either way; it is not known what a Falcon does with more [counts].
inline constexpr double most_motor_counts = 4095.0;

// The torques on the upper arms, each in the direction of its growing angle, with which the handle pushes the hand with
// `force`: A⁻ᵀ F. Empty: A is singular, or something is not finite.
std::optional<Vector<3>> joint_torques(const Vector<3>& force, const Matrix<3>& jacobian) noexcept;

struct MotorCommand {
  MotorNumbers counts{};      // positive pulls an arm in
  bool is_saturated = false;  // scaled down to what the motors may be sent; the force keeps its direction
  bool is_valid = false;      // false: no force can be commanded here, and the counts are 0
};

// The numbers that make `force`. Numbers are whole, and rounding them adds up to 5 mN across the force, however small
// that is: with 6600 counts per N·m its direction is kept within 0.1° from 3 N upwards, and within 0.3° at 1 N.
// Rounding cannot do better without changing the force's magnitude. A motor constant for each leg's motor.
MotorCommand motor_counts(const Vector<3>& force, const Matrix<3>& jacobian,
                          const Vector<3>& counts_per_newton_metre) noexcept;

// The force at the handle that these numbers make, whole or not: what a simulated device answers.
Vector<3> force_of_motor_counts(const Vector<3>& counts, const Matrix<3>& jacobian,
                                const Vector<3>& counts_per_newton_metre) noexcept;

}  // namespace ghostforce
