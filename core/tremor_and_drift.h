// What a hand does by itself: one that means to hold still trembles and drifts, and one that moves on trembles too. A
// function of model time and seed, added to the goal. Plain values, any thread; nothing allocates or throws but
// simulated_hand(). SI units.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "core/conventions.h"
#include "core/goal_path.h"
#include "core/settings.h"
#include "core/wave_sum.h"

namespace ghostforce {

// How a hand moves that means to hold still.
struct TremorAndDrift {
  double tremor_rms = 0.0;           // of each axis [m]
  NumberRange tremor_hz{8.0, 12.0};  // where its tremor is [Hz]
  double drift_speed = 0.0;          // root of the mean square [m/s]
  double seed = 1.0;                 // another whole number: another hand of the same kind

  bool is_still() const noexcept { return tremor_rms == 0.0 && drift_speed == 0.0; }
  friend bool operator==(const TremorAndDrift&, const TremorAndDrift&) = default;
};

// That motion, ready to be asked a thousand times a second.
class TremorAndDriftMotion {
 public:
  // As slow as what a person does without noticing [Hz].
  static constexpr NumberRange drift_hz{0.2, 0.8};
  // A run begins still: the goal starts where it is said to start [s].
  static constexpr double begins_within_s = 0.5;

  TremorAndDriftMotion() = default;
  explicit TremorAndDriftMotion(const TremorAndDrift& tremor_and_drift) noexcept;

  bool is_still() const noexcept { return is_still_; }

  // Away from where the hand means to be; t = 0 is where the run begins, and it is 0 there [m].
  Vector<2> at(double time_s) const noexcept;

  // Where a hand is that means to be at `goal` [m]; a still one: exactly there.
  Vector<2> shaken(const Vector<2>& goal, double time_s) const noexcept { return is_still_ ? goal : goal + at(time_s); }

 private:
  static constexpr std::size_t drift_wave_count = 8;

  TremorWaves tremor_{};
  WaveSum<drift_wave_count> drift_{};
  bool is_still_ = true;
};
static_assert(std::is_trivially_copyable_v<TremorAndDriftMotion>);

// Physiological tremor: a hand held still shakes at 8 to 12 Hz, by a few tenths of a millimetre.
struct Tremor {
  double rms = 0.0002;  // of each axis [m]
  double least_hz = 8.0;
  double greatest_hz = 12.0;
  std::uint64_t seed = 1;
};

// A simulated hand as one waypoint per tick, from 0 to `duration_s`, both included: minimum jerk between the waypoints
// of `aim`, whatever its own motion is, and then held; plus the tremor. The same seed gives the same hand on every
// machine. `rate` [Hz]. Not for the servo thread.
GoalPath simulated_hand(const GoalPath& aim, const Tremor& tremor, double duration_s, double rate);

}  // namespace ghostforce
