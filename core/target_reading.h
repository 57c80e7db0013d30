// Ghost force and proxy drift of a measured device, against a target on the wall that its hand was told to aim at. Pure,
// any dimension; never allocates or throws, any thread. SI units.
//
// Nobody can measure the goal of a real hand. The goal that is inferred with the believed k_u would answer with that very
// belief: against it, the anisotropic strategy has no ghost force, however wrong the belief is. But whoever aims straight
// into the wall at a target t has a goal on the line q_u = t − d n, and at rest (7) leaves just two unknowns,
//     q_h − f_r/k_u = t − d n
// which the device tells: k_u along the wall, d across it.
//     1/k_u = (q_h − t)·a / (f_r·a),   a = f_r less its component along n
//     d     = n·(t − q_h + f_r/k_u)
// Ghost force and drift are then those of core/ghost_force.h at that goal, with that hand. In closed form, with κ = k_r/k_u,
//     ghost force = k_r P_A drift / (1 + κ + k_t/k_c)          (docs/theory.md)
#pragma once

#include <limits>

#include "core/equilibrium.h"
#include "core/ghost_force.h"
#include "core/snapshot.h"

namespace ghostforce {

template <glm::length_t D>
struct TargetReading {
  Vector<D> proxy_drift{0.0};  // from the target [m]
  // [N]; NaN where the device does not tell it: there is no force along the wall, or the hand does not pull towards the
  // line through the target.
  Vector<D> ghost_force{0.0};
};

// `now` is in contact, at rest; its force is the one that the motors gave. `target` lies on the wall [m]. Of the
// stiffnesses, k_r, k_t and k_c are used: what is given or believed of the hand is not.
template <glm::length_t D>
TargetReading<D> read_against_target(const Strategy& strategy, const Wall<D>& wall, const Actuation<D>& actuation,
                                     const Stiffnesses& stiffnesses, const Vector<D>& target,
                                     const StrategySnapshot<D>& now) noexcept {
  TargetReading<D> reading{.proxy_drift = proxy_drift(wall, now.proxy, target)};
  if (strategy.has_every_motor) return reading;  // the reference has no excess over itself
  const Vector<D> sideways = along(wall, now.force);
  const double compliance =  // 1/k_u [m/N]; 0: a hand that cannot be moved
      glm::dot(along(wall, now.device - target), sideways) / glm::dot(sideways, sideways);
  if (!(compliance >= 0.0) || compliance == std::numeric_limits<double>::infinity()) {
    reading.ghost_force = Vector<D>(std::numeric_limits<double>::quiet_NaN());
    return reading;
  }
  const Vector<D> pulled_to = now.device - compliance * now.force;
  const Vector<D> goal = target - depth(wall, pulled_to) * wall.normal;
  Stiffnesses of_this_hand = stiffnesses;
  of_this_hand.k_u = 1.0 / compliance;
  reading.ghost_force = ghost_force(actuation, now.force, equilibrium_fully_actuated(wall, of_this_hand, goal).force);
  return reading;
}

}  // namespace ghostforce
