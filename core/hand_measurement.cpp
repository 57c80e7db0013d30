#include "core/hand_measurement.h"

#include <cmath>

#include "core/simulate.h"
#include "core/tremor_and_drift.h"

namespace ghostforce {

HandEstimate measure_simulated_hand(const Scene& scene, double from_s, double at_most_s) noexcept {
  const double rate = scene.settings.rate;
  const Vector<2> goal = goal_at(scene.goal, from_s);
  TickCoefficients<2> coefficients = coefficients_of(scene.settings);
  TickState<2> state = equilibrium_state(settings_at(scene, scene.settings, from_s), goal);
  state.tick = std::llround(from_s * rate);
  const TremorAndDriftMotion tremor_and_drift(scene.tremor_and_drift);
  HandMeasurement measurement(rate);
  while (time_of(state.tick, rate) - from_s < at_most_s) {
    const double time_s = time_of(state.tick + 1, rate);
    if (!scene.stiffness_path.is_empty()) {
      set_user_stiffness(coefficients, stiffness_at(scene.stiffness_path, time_s));
    }
    tick_and_measure(scene.settings, coefficients, tremor_and_drift.shaken(goal, time_s), state, measurement);
    if (measurement.reading().estimate.is_known()) break;
  }
  return measurement.reading().estimate;
}

}  // namespace ghostforce
