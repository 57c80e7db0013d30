// The two quantities that this program exists to show. Both are reported as 0 out of contact. Pure, any thread.
#pragma once

#include "core/actuation.h"
#include "core/wall.h"

namespace ghostforce {

// P_A (f_r − f_r of the fully actuated strategy at the same goal) [N]: what the strategy pushes along the motors beyond
// what it should. Components across the motors are not ghost forces: an underactuated device cannot make them at all.
template <glm::length_t D>
Vector<D> ghost_force(const Actuation<D>& actuation, const Vector<D>& force, const Vector<D>& full_force) noexcept {
  return actuation.actuated * (force - full_force);
}

// (q_p − q_u) less its component along n [m]: how far the proxy has slid along the wall away from the intent.
template <glm::length_t D>
Vector<D> proxy_drift(const Wall<D>& wall, const Vector<D>& proxy, const Vector<D>& goal) noexcept {
  return along(wall, proxy - goal);
}

}  // namespace ghostforce
