// What can be found out about a Falcon's motors, from what the handle did while they pulled: what a motor count is
// worth, which motor drives which leg, and whether the firmware drops a force by itself. Pure; never allocates or
// throws, any thread. SI units, leg order where nothing else is said.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/conventions.h"
#include "device/falcon/calibration.h"

namespace ghostforce {

// --- What a motor count is worth ---

// The motors' counts, by leg, at one place while the handle went slowly up and down through it.
struct HoldReading {
  Vector<3> up{0.0};
  Vector<3> down{0.0};

  Vector<3> mean() const noexcept { return 0.5 * (up + down); }
};

struct WeightReading {
  Matrix<3> jacobian{1.0};  // ∂angles/∂position at the place
  HoldReading without;
  HoldReading with_weight;
  double weight = 0.0;  // that was hung on the handle [N]
};

// All uncertainties are two standard deviations.
struct MotorConstants {
  bool is_found = false;                 // false: the readings do not agree, or a motor did nothing against the weight
  bool are_alike = false;                // no motor differs from the others by more than the uncertainty
  double counts_per_newton_metre = 0.0;  // of all three, or of the strongest where they differ
  double uncertainty = 0.0;
  Vector<3> strengths{1.0};  // each leg's motor, beside the strongest; all 1 where they are alike
  Vector<3> strength_uncertainties{0.0};
  double misfit = 0.0;         // of the forces, root mean square [N]
  double friction = 0.0;       // felt at the handle [N]
  double handle_weight = 0.0;  // what the motors carried without the weight: handle less what the finger carried [N]
};

// From the counts with which the motors held the handle against a known weight, less those without it, at the same
// places. What is the same both times cancels out: the handle's own weight, a finger on the button. Friction does too,
// because each is the mean of moving slowly up and slowly down through the place. At least two places, so that every
// motor has something to carry at one of them.
MotorConstants find_motor_constants(std::span<const WeightReading> readings) noexcept;

// --- Which motor drives which leg ---

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

// Which of the three numbers in a Falcon's commands drives which leg's motor, and whether a number above 0 pulls the
// arm in.
struct MotorWiring {
  MotorProblem problem = MotorProblem::none;
  LegNumbers motor_of_leg = legs_in_order;
};

// From which arm moved most, and where to, while one motor at a time pulled gently. In a frame's order.
MotorWiring find_motor_wiring(const std::array<MotorPulse, 3>& pulses) noexcept;

// --- Whether the firmware drops a force by itself when it receives nothing ---

// Where the handle was after a silence, between where the force had held it and where the hand alone does.
struct SilenceReading {
  double silence_s = 0.0;
  double held = 0.0;    // how far the force had moved the handle before the silence [m]
  double after = 0.0;   // how far it was moved still, when the silence ended [m]
  double tremor = 0.0;  // how far the handle wandered while the force was held with frames, peak to peak [m]
};

enum class SilenceOutcome : std::uint8_t {
  undecidable,  // the handle wandered too much, or moved too little
  stays,        // the force was there after the longest silence
  drops,        // it was gone
};

struct SilenceVerdict {
  SilenceOutcome outcome = SilenceOutcome::undecidable;
  double still_there_s = 0.0;  // the longest silence after which it surely was
  double gone_s = 0.0;         // the shortest after which it surely was not; for drops
};

// In any order. Readings of one length that disagree decide nothing.
SilenceVerdict judge_silences(std::span<const SilenceReading> readings) noexcept;

}  // namespace ghostforce
