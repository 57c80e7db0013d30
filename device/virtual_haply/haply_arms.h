// HaplyArms: two arms on two motors, as they really move. The motors' shafts and driven links are rotary inertias with
// friction, the handle is a mass, and a hand is a spring and damper on it; or holds the links themselves, where they
// are to be. They stop at hard ends: where the distal links would be stretched out, where either arm would be straight
// or folded, and where the elbows would meet. SI units, angles as in arms_geometry.h.
//
// Each step is an implicit one, and the motion before it is first projected on what the links allow: without torque,
// energy does not grow, whatever the stiffness and the time step. Neither allocates nor throws; one thread.
#pragma once

#include <array>

#include "core/conventions.h"
#include "device/virtual_haply/arms_geometry.h"

namespace ghostforce {

// What a hand does to the arms.
struct HandPull {
  Vector<2> goal{0.0};      // of the handle [m]
  double stiffness = 0.0;   // k_u [N/m]
  double damping = 0.0;     // [N·s/m]
  bool holds_pose = false;  // then it holds the links by these angles, firmly
  Vector<2> pose{0.0};      // [rad]
};

class HaplyArms {
 public:
  struct Options {
    Vector<2> inertias{2e-4};   // of each motor with its driven link [kg·m²]
    Vector<2> damping{2e-4};    // of each shaft [N·m·s/rad]
    Vector<2> friction{5e-4};   // of each shaft, against any motion [N·m]
    double handle_mass = 0.05;  // [kg]
  };

  // Least distance of the elbows, and least sine between an arm's two links.
  static constexpr double least_gap = 0.015;  // [m]
  static constexpr double least_bend = 0.05;

  // `angles` must be within the ends.
  HaplyArms(const ArmsGeometry& geometry, const Options& options, const Vector<2>& angles) noexcept;

  // Lets so much time pass [s] with these torques at the shafts, positive where they increase an angle [N·m].
  void step(double duration, const Vector<2>& torques, const HandPull& hand) noexcept;

  const ArmsGeometry& geometry() const noexcept { return geometry_; }
  const Vector<2>& angles() const noexcept { return angles_; }
  const Vector<2>& speeds() const noexcept { return speeds_; }  // [rad/s]
  const Vector<2>& handle() const noexcept { return place_.handle; }
  const Vector<2>& velocity() const noexcept { return velocity_; }  // of the handle [m/s]
  // That these torques put on a handle that rests [N].
  Vector<2> force_of(const Vector<2>& torques) const noexcept;
  double kinetic_energy() const noexcept;  // [J]

  // How far within each of its ends a pose is; negative: beyond. Of different units, each continuous.
  static constexpr std::size_t ends = 4;
  static std::array<double, ends> room(const ArmsGeometry& geometry, const Vector<2>& angles) noexcept;

 private:
  Vector<2> held_by_ends(Vector<2> speeds, const Matrix<2>& inertia, double duration) const noexcept;
  bool move_to(const Vector<2>& angles) noexcept;
  double stored_energy(const HandPull& hand) const noexcept;  // in the hand [J]

  ArmsGeometry geometry_;
  Options options_;
  Vector<2> angles_;
  Vector<2> speeds_{0.0};
  Vector<2> velocity_{0.0};
  ArmsGeometry::Place place_;
};

}  // namespace ghostforce
