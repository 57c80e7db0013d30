// MeasuringTones: the small known force along the motor that measures the hand (hand_estimator.h),
//     t(t) = p g (sin 2π·3t + 0.6 sin 2π·16t)/1.6
// where g goes from 0 to 1 and back within 0.2 s, so that nothing jumps. They are off by themselves where nothing is
// touched. A plain value, stepped once per tick; never allocates or throws; any one thread.
#pragma once

#include <algorithm>
#include <complex>
#include <numbers>

#include "core/hand_estimator.h"

namespace ghostforce {

// p [N]; it is felt as about 0.7 mm at 3 Hz.
inline constexpr double usual_tone_force = 0.4;
inline constexpr double greatest_tone_force = 0.4;

class MeasuringTones {
 public:
  static constexpr double fade_s = 0.2;

  // The tones' force along the motor, from this tick to the next [N]. `force`: p; `period`: of a tick [s].
  double step(bool are_wanted, bool in_contact, double force, double period) noexcept {
    const double way = are_wanted && in_contact ? period / fade_s : -period / fade_s;
    gain_ = std::clamp(gain_ + way, 0.0, 1.0);
    if (gain_ == 0.0) {
      low_.angle = high_.angle = 1.0;
      return 0.0;
    }
    if (period != period_) set_period(period);
    low_.angle *= low_.turn;
    high_.angle *= high_.turn;
    return force * gain_ / 1.6 * (low_.angle.imag() + 0.6 * high_.angle.imag());
  }

  void silence() noexcept { *this = {}; }

  // g [1]
  double gain() const noexcept { return gain_; }

 private:
  // A pointer that turns: two sines would take longer than a tick. Rounding makes it longer by some 1e-16 a turn.
  struct Pointer {
    std::complex<double> angle{1.0};
    std::complex<double> turn{1.0};  // in a tick
  };

  void set_period(double period) noexcept {
    period_ = period;
    low_.turn = std::polar(1.0, 2.0 * std::numbers::pi * low_tone_hz * period);
    high_.turn = std::polar(1.0, 2.0 * std::numbers::pi * high_tone_hz * period);
  }

  double gain_ = 0.0;
  double period_ = 0.0;
  Pointer low_;
  Pointer high_;
};

}  // namespace ghostforce
