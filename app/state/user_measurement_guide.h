// The guided measurement of the user: it sets a ratio ρ that is off, the person turns ρ until the proxy no longer
// slides along the wall, and takes that as a reading of k_u; five times, from both sides. Where the goal is given, the
// drift is seen against it; a real hand's goal nobody can measure, so a target on the wall is drawn to aim at.
//
// The state is a value of the session; the functions edit the session. UI thread. SI units.
#pragma once

#include <string_view>

#include "app/state/session.h"
#include "core/snapshot.h"
#include "device/report/motor_report.h"

namespace ghostforce {

bool is_measuring(const Session& session) noexcept;

// The screen keeps what the measurement is to find out, or what theory makes of it: until it has ended, and of a hand
// that is simulated until the person asks for its given stiffness.
bool hides_answer(const Session& session) noexcept;

// The curves of theory know the hand, and so does what was measured live: they are nowhere to be seen while a person
// measures it.
bool hides_curves(const Session& session) noexcept;

// Shows what was hidden. The measurement of a hand that was given its stiffness is then blind only if it has ended.
void reveal_hand(Session& session) noexcept;

// From the state that the session is in. The input stays: the first step says so where it never rests.
void start_measuring(Session& session);

// Once per frame, with what is seen now.
void follow_measurement(Session& session, const Snapshot& snapshot, const MotorReport& motors);

// Takes the reading, or says what to do first. The last one ends the measurement: ratio and strategy are as before.
void take_reading(Session& session);

// Ratio and strategy are as before, and no reading is left.
void cancel_measurement(Session& session);

// The median of the readings becomes the k_u that the renderer believes in.
void believe_measurement(Session& session);

// So does what was measured in another way [N/m].
void believe_measured(Session& session, double k_u) noexcept;

// Of the readings' k_u [N/m].
Spread spread_of(const UserMeasurement& measurement);

// The step as a sentence for the person.
std::string_view words_for(MeasuringStep step, bool has_target) noexcept;

// A drift below this counts as none [m]: a hand that is measured trembles, a simulated one does not.
double null_drift(const UserMeasurement& measurement) noexcept;

// Turns the ratio of the anisotropic strategy by so much, 1.05 for 5 % more; held in the range of a scene.
void turn_ratio(Session& session, double factor) noexcept;

}  // namespace ghostforce
