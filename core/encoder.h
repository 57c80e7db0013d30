// What a renderer knows of where the device is: an encoder counts steps. Pure, never allocates or throws, any thread.
#pragma once

#include <cmath>

#include "core/conventions.h"

namespace ghostforce {

// The whole steps of each axis that are nearest to the device [m]. `step` [m]; 0: the device itself, to the last bit.
template <glm::length_t D>
Vector<D> measured_position(double step, const Vector<D>& device) noexcept {
  if (step == 0.0) return device;
  Vector<D> measured;
  for (glm::length_t i = 0; i < D; ++i) measured[i] = step * std::nearbyint(device[i] / step);
  return measured;
}

}  // namespace ghostforce
