// ArmsGeometry: where the handle of two arms on two motors is, and how it moves with them. Written for the simulated
// device alone, without a look at the driver's kinematics: the two are to be checked against each other.
//
// Motor 1 is at the origin, motor 2 on the x axis; y points away from the motors, towards the person. Angles are those
// of the driven links, counter-clockwise from +x. m, rad. A plain value, any thread; never allocates or throws.
#pragma once

#include <optional>

#include "core/conventions.h"

namespace ghostforce {

struct ArmsGeometry {
  double driven = 0.07;  // each link on a motor's shaft [m]
  double distal = 0.09;  // each link from there to the handle [m]
  double apart = 0.038;  // the motors [m]

  struct Place {
    Vector<2> handle{0.0};
    Vector<2> elbow_1{0.0};
    Vector<2> elbow_2{0.0};
    Matrix<2> jacobian{1.0};  // of the handle by the angles [m/rad]
  };

  // Empty: the distal links do not meet, or are one upon the other.
  std::optional<Place> place(const Vector<2>& angles) const noexcept;

  // The angles with which the handle is there and both elbows point outwards. Empty: out of reach.
  std::optional<Vector<2>> angles_at(const Vector<2>& handle) const noexcept;

  // On the middle line, where the arms can go a good way to all sides.
  Vector<2> middle() const noexcept { return {0.5 * apart, 0.5625 * (driven + distal)}; }
};

}  // namespace ghostforce
