// LoopMeter: the energy that the rendering gave to the hand on one closed loop of the device, and the area that the
// loop encloses; what energy_per_loop() in energy.h predicts. Never allocates or throws; one thread.
#pragma once

#include "core/conventions.h"

namespace ghostforce {

struct MeasuredLoop {
  double area = 0.0;    // S, counter-clockwise + [m²]
  double energy = 0.0;  // W over the loop [J]
};

class LoopMeter {
 public:
  // `device` is q_h [m], `energy` W since some start [J].
  LoopMeter(const Vector<2>& device, double energy) noexcept
      : start_(device), last_(device), first_energy_(energy), last_energy_(energy) {}

  void add(const Vector<2>& device, double energy) noexcept {
    const Vector<2> before = last_ - start_;
    const Vector<2> now = device - start_;
    twice_area_ += before.x * now.y - before.y * now.x;
    last_ = device;
    last_energy_ = energy;
  }

  // Of the path so far, closed by a straight line back to its start.
  MeasuredLoop loop() const noexcept { return {0.5 * twice_area_, last_energy_ - first_energy_}; }

 private:
  Vector<2> start_;
  Vector<2> last_;
  double first_energy_;
  double last_energy_;
  double twice_area_ = 0.0;
};

}  // namespace ghostforce
