// Where the renderer's belief about the user comes from, and where the guided measurement of the user stands, which
// user_measurement_guide.h leads. Values of the session. SI units.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/settings.h"
#include "core/user_measurement.h"

namespace ghostforce {

// Where the k_u comes from that the renderer believes in.
enum class BeliefSource : std::uint8_t {
  typed,     // a person has set it, or it is the same as the hand's
  measured,  // by the guided measurement, or once on the stage
  live,      // tones on the motor measure the hand, and the belief follows: the servo alone changes it
};

// The settings that are the person's own choice: a belief that follows the hand changes by itself and is none.
inline Settings chosen_settings(Settings settings, BeliefSource source) noexcept {
  if (source == BeliefSource::live) settings.stiffnesses.believed_k_u.reset();
  return settings;
}

inline constexpr std::size_t readings_wanted = 5;

// What the person has to do next.
enum class MeasuringStep : std::uint8_t {
  go_on,         // time is paused
  leave_circle,  // the input never rests
  arm,           // the motors of the device are off
  choose_a,      // another strategy than the anisotropic one is active
  turn_wall,     // this wall shows no drift, whatever ρ
  render,        // k_r is 0
  press,         // no contact
  press_less,    // the motors are at their limit
  raise_ratio,   // ρ too low: the drift is positive
  lower_ratio,
  hold_still,
  stiffen,  // no drift is left at a ratio that no hand has
  take,
};

struct TakenReading {
  double tracking_ratio = 0.0;  // ρ°
  double k_u = 0.0;             // [N/m]
};

struct UserMeasurement {
  enum class Stage : std::uint8_t { off, nulling, done };

  Stage stage = Stage::off;
  std::vector<TakenReading> readings;
  std::optional<Vector<2>> target;  // on the wall, to aim at [m]; empty: the goal is given
  MeasuringStep step = MeasuringStep::press;
  bool was_refused = false;     // "Take" came too early; until a step is done
  bool has_begun_anew = false;  // something was changed that the readings depended on
  std::optional<double> drift;  // as drift_direction() in core/user_measurement.h has it; empty: not in contact [m]
  double k_r = 0.0;             // that the readings are made with [N/m]
  double first_ratio = 1.0;     // ρ at the start of this reading: what the range of its slider goes by
  bool is_revealed = false;     // the person has asked for the stiffness that the hand was given
  bool was_blind = true;        // not before the last reading
  bool has_news = false;        // something to look at has appeared; who has brought it into sight clears it
  // Of the hand that was measured, where it is a simulated one: what the median is to be compared with [N/m].
  std::optional<double> given_k_u;

  // What a cancel goes back to.
  StrategyId active_before = StrategyId::anisotropic;
  std::optional<double> ratio_before;
  BeliefSource belief_source_before = BeliefSource::typed;

  // What the readings are of: other settings or another hand begin anew.
  const void* scene = nullptr;
  Settings settings;
  std::string input;

  // Since when hand and device rest.
  Settings seen_settings;
  RestWatch<2> device_rest{0.0};
  RestWatch<2> goal_rest{0.0};
  double seen_s = 0.0;
};

}  // namespace ghostforce
