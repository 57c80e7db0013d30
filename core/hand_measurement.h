// HandMeasurement: measures the hand tick by tick, at a real device or at a simulated one. Tones out, samples in, an
// estimate every HandEstimator::period_s. A plain value of fixed size; nothing here allocates or throws; any one
// thread. SI units, along the motor.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <glm/geometric.hpp>

#include "core/hand_estimator.h"
#include "core/measuring_tones.h"
#include "core/scene.h"
#include "core/settings.h"
#include "core/strategy.h"
#include "core/tick.h"

namespace ghostforce {

// Readings of a device that come later than this leave a gap [periods]: a tenth of a turn of the high tone at 1 kHz.
inline constexpr double longest_gap_periods = 5.0;

// Where samples come from: those of another axis, or of another device, do not continue those before.
struct HandSource {
  double axis_angle = 0.0;                // of the motor [rad]
  std::optional<StrategyId> simulated{};  // whose device the hand is on; empty: the real one

  friend bool operator==(const HandSource&, const HandSource&) = default;
};

class HandMeasurement {
 public:
  // `rate`: ticks per second [Hz].
  explicit HandMeasurement(double rate) noexcept
      : estimator_(rate), period_(1.0 / rate), ticks_per_estimate_(std::llround(HandEstimator::period_s * rate)) {}

  // From here on it is ticked at another rate [Hz]. Tones that sound go on.
  void use_rate(double rate) noexcept {
    estimator_ = HandEstimator(rate);
    period_ = 1.0 / rate;
    ticks_per_estimate_ = std::llround(HandEstimator::period_s * rate);
    interrupt();
  }

  // The samples that come next do not continue those before.
  void interrupt(HandUnknown why = HandUnknown::collecting) noexcept {
    estimator_.reset(why);
    reading_.estimate = {.why = why};
  }
  // Another run begins: what sounds falls silent at once, and nothing that was measured counts any more.
  void restart() noexcept {
    tones_.silence();
    reading_ = {};
    interrupt();
  }

  // The tones' force from this tick to the next [N], once per tick; `force`: their amplitude p.
  double sound(bool are_wanted, bool in_contact, double force) noexcept {
    reading_.is_measuring = are_wanted;
    return tones_.step(are_wanted, in_contact, force, period_);
  }
  bool is_sounding() const noexcept { return tones_.gain() > 0.0; }

  // What the tick at `time_s` has made of it. True: there is a new estimate.
  bool add(const HandSample& sample, double time_s) noexcept {
    estimator_.add(sample);
    reading_.tone_gain = tones_.gain();
    reading_.filled = estimator_.filled();
    if (++ticks_ < ticks_per_estimate_) return false;
    ticks_ = 0;
    reading_.estimate = estimator_.estimate();
    reading_.at_s = time_s;
    return true;
  }

  const HandReading& reading() const noexcept { return reading_; }

 private:
  MeasuringTones tones_;
  HandEstimator estimator_;
  HandReading reading_;
  double period_;  // of a tick [s]
  std::int64_t ticks_per_estimate_;
  std::int64_t ticks_ = 0;  // since the newest estimate
};

// The next tick of a simulation, with the tones on the active strategy's device, as the servo has them live
// (measuring_tones.h). `coefficients`: of these settings. True: there is a new estimate.
inline bool tick_and_measure(const Settings& settings, const TickCoefficients<2>& coefficients, const Vector<2>& goal,
                             TickState<2>& state, HandMeasurement& measurement) noexcept {
  tick(coefficients, goal, state);
  const std::size_t active = index_of(settings.active);
  TickState<2>::StrategyState& own = state.strategies[active];
  const Vector<2> axis = direction_at(settings.actuated_angle);
  const double tone = measurement.sound(true, own.in_contact, usual_tone_force);
  own.tone = tone * axis;
  const Vector<2> place = measured_position(settings, own.motion.position);
  const Vector<2> force = rendered_force<2>(coefficients.strategies[active], own.proxy, place) + own.tone;
  return measurement.add({.position = glm::dot(axis, place),
                          .force = glm::dot(axis, force),
                          .tone = tone,
                          .in_contact = own.in_contact,
                          .is_at_limit = false},
                         time_of(state.tick, settings.rate));
}

// What a burst of the tones tells of a scene's hand: how stiff it is, if it holds still from `from_s` on with its
// devices at rest. Measures until it is known, or for `at_most_s`.
HandEstimate measure_simulated_hand(const Scene& scene, double from_s, double at_most_s) noexcept;

}  // namespace ghostforce
