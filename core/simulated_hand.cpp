#include "core/simulated_hand.h"

#include "core/tick.h"
#include "core/wave_sum.h"

namespace ghostforce {

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
