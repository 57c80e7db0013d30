// Where the emulated Falcon's hand goes in a scene with a floor at -0.01 m, by the words that armed_program says.
#pragma once

#include <string_view>

#include "device/falcon/falcon_input.h"
#include "tests/emulation/falcon_chip.h"

namespace ghostforce {

inline HandPlan hand_in_scene(const Vector<2>& place, double time_s = 0.3) {
  return hand_at(FalconPlane(FalconCalibration{}, Vector<2>(0.0)).in_workspace(place), time_s);
}

// Leaves the hand alone at any other word. Two places are outside: a driver that has opened the device anew waits until
// the encoders move.
inline void lead_hand(FalconChip& chip, std::string_view word) {
  if (word == "outside") chip.lead_hand(hand_in_scene({0.02, 0.02}));
  if (word == "aside") chip.lead_hand(hand_in_scene({-0.02, 0.03}));
  if (word == "inside") chip.lead_hand(hand_in_scene({0.0, -0.04}));
}

}  // namespace ghostforce
