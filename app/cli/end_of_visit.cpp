#include "app/cli/end_of_visit.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/doctor/readiness.h"
#include "core/safety.h"

namespace ghostforce {

EndOfVisit end_of_visit(const MotorReport& motors, std::span<const ReadinessStepState> readiness,
                        const EndOfVisit& of_input) {
  if (const OffReasonEntry& reason = entry_of(motors.reason); reason.is_safety_limit) {
    return {ExitCode::safety_stop, fmt::format("The motors went off ({}). {}", reason.title, reason.remedy)};
  }
  // Whoever could read the handle has had what they came for.
  const auto step = std::ranges::find_if(readiness, &ReadinessStepState::is_current);
  if (step == readiness.end() || step->step > ReadinessStep::homed) return of_input;
  const char* const what = step->step == ReadinessStep::seen ? "No Falcon is plugged in" : "The Falcon is not ready";
  return {exit_code_of(readiness, true), fmt::format("{}. {}", what, step->words)};
}

}  // namespace ghostforce
