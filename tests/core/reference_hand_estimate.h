// The estimator's equations once more, for a window that is there as a whole: no sums that slide, parabolas by least
// squares with Eigen, Fourier sums term by term. Tests compare HandEstimator with it.
#pragma once

#include <span>

#include "core/hand_estimator.h"

namespace ghostforce {

struct ReferenceHandEstimate {
  double k_u;      // [N/m]
  double sigma;    // [N/m]
  double mass;     // [kg]
  double damping;  // [N·s/m]
};

// Of the last `window_s` of the samples, which must be one sample more than that, or more.
ReferenceHandEstimate reference_hand_estimate(std::span<const HandSample> samples, double rate, double window_s = 2.0);

}  // namespace ghostforce
