// Which of the three numbers in a Falcon's commands drives which leg's motor, and whether a number above 0 pulls the
// arm in: from which arm moved most, and where to, while one motor at a time pulled gently. Pure; never allocates or
// throws, any thread.
#pragma once

#include <array>
#include <cstdint>

#include "device/falcon/calibration.h"

namespace ghostforce {

// What the legs did when one number of a command was `counts` and the others 0.
struct MotorPulse {
  // The arm must move so far before anything is concluded [counts].
  static constexpr double least_move = 8.0;

  double counts = 0.0;
  Vector<3> moved{0.0};  // each leg, where a person held the handle [leg counts]

  bool has_moved() const noexcept;
};

enum class MotorProblem : std::uint8_t {
  none,
  no_movement,     // a motor moved nothing: no current, broken, or the hand was too firm
  same_leg_twice,  // two numbers moved the same leg
};

struct MotorWiring {
  MotorProblem problem = MotorProblem::none;
  LegNumbers motor_of_leg = legs_in_order;
};

// In a frame's order.
MotorWiring find_motor_wiring(const std::array<MotorPulse, 3>& pulses) noexcept;

}  // namespace ghostforce
