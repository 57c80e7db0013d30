// What a motor count is worth: from the counts with which the motors held the handle against a known weight, less those
// without it, at the same places. What is the same both times cancels out: the handle's own weight, a finger on the
// button. Friction does too, because each is the mean of moving slowly up and slowly down through the place. Pure;
// never allocates or throws, any thread. SI units, leg order.
#pragma once

#include <span>

#include "core/conventions.h"

namespace ghostforce {

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

// At least two places, so that every motor has something to carry at one of them.
MotorConstants find_motor_constants(std::span<const WeightReading> readings) noexcept;

}  // namespace ghostforce
