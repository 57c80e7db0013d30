#include "app/state/target.h"

#include <limits>

#include "core/target_reading.h"

namespace ghostforce {

std::optional<Vector<2>> target_of(const Session& session, const MotorReport& motors) noexcept {
  const bool is_wanted = session.aims_at_target || session.measurement.stage == UserMeasurement::Stage::nulling;
  if (!motors.has_motors || !is_wanted) return std::nullopt;
  return projection(wall_of(session.settings), session.scene->goal.points.back());
}

void measure_against_target(const Vector<2>& target, const Settings& settings, bool has_full_force,
                            Snapshot& snapshot) noexcept {
  if (!snapshot.measured) return;
  snapshot.has_target = true;
  StrategySnapshot<2>& now = snapshot.strategies[index_of(*snapshot.measured)];
  if (!now.in_contact) return;
  const TargetReading<2> reading = read_against_target(strategy(*snapshot.measured), wall_of(settings),
                                                       actuation_of(settings), settings.stiffnesses, target, now);
  now.proxy_drift = reading.proxy_drift;
  now.ghost_force = has_full_force ? reading.ghost_force : Vector<2>(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace ghostforce
