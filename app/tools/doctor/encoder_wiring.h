// Which of the three numbers in a Falcon's answers belongs to which leg, and whether it grows as the arm swings out:
// from where the encoders went while a person moved the handle in known directions. Pure; never allocates or throws,
// any thread. SI units, device frame: x right, y up, z out towards the person.
#pragma once

#include <span>

#include "device/falcon/calibration.h"

namespace ghostforce {

// The encoders before and after the handle was moved from the middle of its space, about 3 cm in a direction.
struct HandMove {
  Vector<3> direction{0.0};  // of length 1
  Vector<3> from{0.0};       // encoders, in a frame's order [counts]
  Vector<3> to{0.0};
};

struct EncoderWiring {
  // Every number moved less than this: nobody moved the handle [counts].
  static constexpr double least_move = 60.0;
  // With the cosine between what was seen and what the legs must do: below this the hand went another way.
  static constexpr double least_agreement = 0.93;

  LegNumbers encoder_of_leg = legs_in_order;
  double agreement = 0.0;  // the smallest cosine of all moves; 1: exactly as this wiring has it
  double runner_up = 0.0;  // agreement of the next best wiring
  bool has_moved = false;

  bool is_certain() const noexcept { return has_moved && agreement >= least_agreement && agreement - runner_up >= 0.1; }
};

// A person who lifts the handle when it should go right, and the other way round, is not noticed: the legs look the
// same in that mirror.
EncoderWiring find_encoder_wiring(std::span<const HandMove> moves, const FalconGeometry& geometry) noexcept;

// With the handle pushed in to its stop, all three arms are at the same angle, apart by at most as much as a hand is
// crooked: some 80 counts for a millimetre across.
inline constexpr double crooked_counts = 120.0;

// What must be added to each number so that they do: for those that count the other way, of which nobody knows where
// they begin. `at_stop` in a frame's order. Where all three count the other way nothing can be said, and it is 0.
MotorNumbers offsets_at_stop(const Vector<3>& at_stop, const LegNumbers& encoder_of_leg) noexcept;

}  // namespace ghostforce
