// SimulatedArm: the Falcon's three legs as seen from their ends. A mass at the handle with damping, the motors' force
// on it and the pull of a hand, inside stops; and the encoders, which know the handle only through the legs. Device
// frame of falcon/kinematics.h, SI units.
//
// Each step is an implicit one inside a convex set, so that no mass, stiffness, time step or motor command makes it
// unstable: without motors energy never grows, and the handle never leaves the stops. Neither allocates nor throws; one
// thread.
#pragma once

#include <array>

#include "core/conventions.h"
#include "device/falcon/calibration.h"

namespace ghostforce {

class SimulatedArm {
 public:
  struct Options {
    FalconGeometry geometry{};
    double counts_per_newton_metre = 6600.0;
    // How the device really is, in the words of a calibration (falcon/calibration.h). An encoder that counts the other
    // way does so from where its arm stands when the handle is pushed in: there homing finds it either way.
    Vector<3> motor_strengths{1.0};
    LegNumbers motor_of_leg = legs_in_order;
    LegNumbers encoder_of_leg = legs_in_order;
    double mass = 0.1;      // of handle and hand [kg]
    double damping = 5.0;   // [N·s/m]
    double weight = 0.0;    // of the handle [N]
    double friction = 0.0;  // of the joints, felt at the handle [N]
    Vector<3> start{0.0, 0.0, 0.11};
  };

  // The stops: turned around the z axis, with a cylinder's side that narrows towards the far end.
  static constexpr double nearest = 0.074;            // z [m]
  static constexpr double farthest = 0.174;           // z [m]
  static constexpr double narrows_from = 0.155;       // z [m]
  static constexpr double radius = 0.055;             // [m]
  static constexpr double radius_at_farthest = 0.03;  // [m]

  // A start outside the stops is moved to where they are.
  explicit SimulatedArm(const Options& options) noexcept;

  // Lets so much time pass [s] while the motors have these numbers, a hand pulls the handle to `goal`, with a stiffness
  // of 0 or more [N/m], and `load` hangs on it [N].
  void step(double duration, const MotorNumbers& motors, const Vector<3>& goal, double stiffness,
            double load = 0.0) noexcept;

  const Vector<3>& position() const noexcept { return position_; }  // [m]
  const Vector<3>& velocity() const noexcept { return velocity_; }  // [m/s]
  const Vector<3>& force() const noexcept { return force_; }        // the motors', on the handle, in the last step [N]

  // As a frame has them; with encoders as assumed, from the geometry's zero. Whole counts.
  const std::array<int, 3>& encoders() const noexcept { return encoders_; }

 private:
  bool move_to(const Vector<3>& position) noexcept;

  FalconKinematics kinematics_;
  Options options_;
  int pushed_in_ = 0;  // where every arm then stands [counts]
  Vector<3> position_{};
  Vector<3> velocity_{};
  Vector<3> force_{};
  Matrix<3> jacobian_{1.0};
  std::array<int, 3> encoders_{};
};

}  // namespace ghostforce
