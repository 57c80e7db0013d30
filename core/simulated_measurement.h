// The tones on a simulated device, tick by tick, as the servo has them live (measuring_tones.h): what a burst of them would
// tell of a scene's hand. Pure; any thread. SI units.
#pragma once

#include <cstddef>

#include <glm/geometric.hpp>

#include "core/hand_measurement.h"
#include "core/measuring_tones.h"
#include "core/scene.h"
#include "core/settings.h"
#include "core/tick.h"

namespace ghostforce {

// The next tick, with the tones on the active strategy's device. `coefficients`: of these settings. True: there is a new
// estimate.
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

// How stiff the scene's hand is, if it holds still from that moment on with its devices at rest: measured until it is known,
// or for so long.
HandEstimate measure_simulated_hand(const Scene& scene, double from_s, double at_most_s) noexcept;

}  // namespace ghostforce
