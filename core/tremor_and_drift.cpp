#include "core/tremor_and_drift.h"

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "core/goal_path.h"
#include "core/tick.h"
#include "core/wave_sum.h"

namespace ghostforce {

TremorAndDriftMotion::TremorAndDriftMotion(const TremorAndDrift& tremor_and_drift) noexcept
    : is_still_(tremor_and_drift.is_still()) {
  RandomShares random(static_cast<std::uint64_t>(tremor_and_drift.seed));
  tremor_ = tremor_waves(tremor_and_drift.tremor_hz, tremor_and_drift.tremor_rms, random);
  // All waves of both axes are equally fast: 2n of them, each with half the square of its greatest speed.
  const double wave_speed = tremor_and_drift.drift_speed / std::sqrt(static_cast<double>(drift_wave_count));
  const auto amplitude = [wave_speed](double hz) { return wave_speed / (2.0 * std::numbers::pi * hz); };
  drift_ = random_waves<drift_wave_count>(drift_hz, amplitude, random);
}

Vector<2> TremorAndDriftMotion::at(double time_s) const noexcept {
  Vector<2> way(0.0);
  tremor_.add_to(way, time_s);
  drift_.add_to(way, time_s);
  return minimum_jerk(std::clamp(time_s / begins_within_s, 0.0, 1.0)) * way;
}

GoalPath simulated_hand(const GoalPath& aim, const Tremor& tremor, double duration_s, double rate) {
  GoalPath smooth = aim;
  smooth.motion = Motion::minimum_jerk;
  RandomShares random(tremor.seed);
  const TremorWaves waves = tremor_waves({tremor.least_hz, tremor.greatest_hz}, tremor.rms, random);

  GoalPath hand;
  const std::int64_t last = std::llround(duration_s * rate);
  for (std::int64_t tick = 0; tick <= last; ++tick) {
    const double time_s = time_of(tick, rate);
    Vector<2> at = goal_at(smooth, time_s);
    waves.add_to(at, time_s);
    hand.points.push_back(at);
    hand.times.push_back(time_s);
  }
  return hand;
}

}  // namespace ghostforce
