// The proxy: where the wall lets the tracked point go. Soft and hard constraint alike, without a matrix inverse and
// without a special case. Pure, never allocates or throws, any thread.
#pragma once

#include <glm/geometric.hpp>

#include "core/actuation.h"
#include "core/wall.h"

namespace ghostforce {

// How far the proxy leaves the device per metre of the device's depth [1]; (22) soft, (25) in time, and their limit
// for the hard constraint. With C = K_t⁻¹ n and s = n·C:
//     gain = C · k_c / (1 + k_c s)
//     gain = C / s                     k_c = ∞
// It depends on the settings only, so the tick computes it once per change of a setting.
template <glm::length_t D>
Vector<D> proxy_gain(const Vector<D>& normal, const Coupling<D>& coupling, double k_c) noexcept {
  const Vector<D> C = coupling.tracking_compliance * normal;
  const double s = glm::dot(normal, C);
  // k_c / (1 + k_c s), written so that k_c = ∞ gives 1 / s.
  return C / (1.0 / k_c + s);
}

template <glm::length_t D>
struct Proxy {
  Vector<D> position;  // q_p [m]
  bool in_contact;     // the wall acts
};

// (3)(22)(25)  q_p = q_h + gain · n·(o − q_h)     where n·(q_h − o) < 0
//              q_p = q_h                          in free space
// Puts it into `proxy`, axis by axis: see tick.h. True: the wall acts.
template <glm::length_t D>
bool place_proxy(const Vector<D>& device, const Wall<D>& wall, const Vector<D>& gain, Vector<D>& proxy) noexcept {
  const double device_depth = depth(wall, device);
  const bool in_contact = device_depth > 0.0;
  for (glm::length_t i = 0; i < D; ++i) proxy[i] = in_contact ? device[i] + gain[i] * device_depth : device[i];
  return in_contact;
}

template <glm::length_t D>
Proxy<D> proxy_of(const Vector<D>& device, const Wall<D>& wall, const Vector<D>& gain) noexcept {
  Proxy<D> proxy{device, false};
  proxy.in_contact = place_proxy(device, wall, gain, proxy.position);
  return proxy;
}

}  // namespace ghostforce
