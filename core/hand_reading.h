// HandReading: what the servo tells of the hand that it measures. Trivially copyable: it crosses threads whole.
#pragma once

#include <type_traits>

#include "core/hand_estimator.h"

namespace ghostforce {

struct HandReading {
  bool is_measuring = false;  // the tones are wanted
  double tone_gain = 0.0;     // how much of them sounds, 0 to 1
  double filled = 0.0;        // how much of the window is, 0 to 1
  HandEstimate estimate{};    // the newest; a new one every HandEstimator::period_s
  double at_s = 0.0;          // when it was made, model time [s]
  double believed_k_u = 0.0;  // k̂_u in use [N/m]; where it follows the hand, the servo alone changes it
};
static_assert(std::is_trivially_copyable_v<HandReading>);

}  // namespace ghostforce
