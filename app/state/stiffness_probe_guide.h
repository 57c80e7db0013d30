// What begins, follows and uses the probe that measures the hand (session.h). Edits the session; UI thread. SI units.
#pragma once

#include "app/state/session.h"
#include "core/hand_estimator.h"
#include "core/snapshot.h"
#include "device/report/motor_report.h"

namespace ghostforce {

// From the beginning. The number that is there is the one before.
void start_stiffness_probe(Session& session);

// None is asked for any more, and only the last number is kept, to be compared with.
void end_stiffness_probe(Session& session) noexcept;

// Once per frame, with what is seen now.
void follow_stiffness_probe(Session& session, const Snapshot& snapshot, const MotorReport& motors,
                            const HandReading& hand);

// As it is when it has come to that estimate; in front of the wall it still waits.
void show_stiffness_probe(Session& session, const HandEstimate& estimate) noexcept;

// What is known becomes the k_u that the renderer believes in. Does nothing where nothing is known.
void believe_stiffness_probe(Session& session);
// And that is what it believes in now.
bool stiffness_probe_is_believed(const Session& session) noexcept;

// What its button means: to believe what is known, outside of a lesson; else to measure (again). Does nothing while it
// runs.
void press_stiffness_probe(Session& session);

// The stage wants the hand to be measured.
bool wants_tones(const Session& session) noexcept;

}  // namespace ghostforce
