#include "device/falcon_measurement/motor_wiring.h"

#include <algorithm>
#include <cmath>

namespace ghostforce {

bool MotorPulse::has_moved() const noexcept {
  return std::max({std::abs(moved.x), std::abs(moved.y), std::abs(moved.z)}) >= least_move;
}

MotorWiring find_motor_wiring(const std::array<MotorPulse, 3>& pulses) noexcept {
  MotorWiring wiring;
  wiring.motor_of_leg = {};
  for (std::size_t number = 0; number < pulses.size(); ++number) {
    const MotorPulse& pulse = pulses[number];
    if (!pulse.has_moved()) return {.problem = MotorProblem::no_movement};
    glm::length_t leg = 0;
    for (glm::length_t i = 1; i < 3; ++i) {
      if (std::abs(pulse.moved[i]) > std::abs(pulse.moved[leg])) leg = i;
    }
    std::int8_t& of_leg = wiring.motor_of_leg[static_cast<std::size_t>(leg)];
    if (of_leg != 0) return {.problem = MotorProblem::same_leg_twice};
    // Above 0 pulls in, where the leg's counts shrink.
    const bool pulls_in = pulse.moved[leg] * pulse.counts < 0.0;
    const int counted = static_cast<int>(number) + 1;
    of_leg = static_cast<std::int8_t>(pulls_in ? counted : -counted);
  }
  return wiring;
}

}  // namespace ghostforce
