// The target on the wall that the hand at a device is told to aim at, and what is known with it. Pure; UI thread.
#pragma once

#include <optional>

#include "app/state/session.h"
#include "core/snapshot.h"
#include "device/report/motor_report.h"

namespace ghostforce {

// While a hand at a device is measured, or the person has asked for a target: the foot of the scene's last waypoint on
// the wall [m].
std::optional<Vector<2>> target_of(const Session& session, const MotorReport& motors) noexcept;

// Puts the measured strategy's ghost force and drift against the target; snapshots of a simulation stay as they are.
// `settings`: those of the tick, with the k_r that the motors had. `has_full_force`: they gave all that was asked of
// them; else its ghost force is not known.
void measure_against_target(const Vector<2>& target, const Settings& settings, bool has_full_force,
                            Snapshot& snapshot) noexcept;

}  // namespace ghostforce
