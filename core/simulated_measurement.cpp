#include "core/simulated_measurement.h"

#include "core/hand_unrest.h"

namespace ghostforce {

HandEstimate measure_simulated_hand(const Scene& scene, TickState<2> state, double at_most_s) noexcept {
  TickCoefficients<2> coefficients = coefficients_of(scene.settings);
  const UnrestMotion unrest(scene.unrest);
  HandMeasurement measurement(scene.settings.rate);
  const double begin_s = time_of(state.tick, scene.settings.rate);
  while (time_of(state.tick, scene.settings.rate) - begin_s < at_most_s) {
    const double time_s = time_of(state.tick + 1, scene.settings.rate);
    if (!scene.stiffness_path.is_empty()) {
      set_user_stiffness(coefficients, stiffness_at(scene.stiffness_path, time_s));
    }
    const Vector<2> goal = unrest.shaken(goal_at(scene.goal, time_s), time_s);
    tick_and_measure(scene.settings, coefficients, goal, state, measurement);
    if (measurement.reading().estimate.is_known()) break;
  }
  return measurement.reading().estimate;
}

}  // namespace ghostforce
