#include "app/cli/end_of_visit.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "app/doctor/readiness.h"
#include "core/safety.h"

namespace ghostforce {
namespace {

EndOfVisit end_with(const FalconReport& report) {
  if (report.is_readable()) return {};
  const std::vector<RungState> ladder = ladder_of(report, nullptr);
  const auto rung = std::ranges::find_if(ladder, &RungState::is_current);
  if (rung == ladder.end()) return {};
  const char* const what = rung->rung == Rung::seen ? "No Falcon is plugged in" : "The Falcon is not ready";
  return {exit_code_of(report, true), fmt::format("{}. {}", what, rung->words)};
}

EndOfVisit end_with(SpaceMouseReading::Trouble trouble) {
  switch (trouble) {
    case SpaceMouseReading::Trouble::none:
      return {};
    case SpaceMouseReading::Trouble::absent:
      return {ExitCode::device_absent, "No SpaceMouse is plugged in. Plug one in, or choose another --input."};
    case SpaceMouseReading::Trouble::not_allowed:
      return {ExitCode::device_refused,
              "This user may not open the SpaceMouse. Run 'ghostforce doctor --install-udev' once, then plug it in "
              "again."};
    case SpaceMouseReading::Trouble::not_opened:
      return {ExitCode::device_refused, "The SpaceMouse cannot be opened. Close the other program that has it."};
  }
  return {};
}

}  // namespace

EndOfVisit end_of_visit(const MotorReport& motors, const FalconReport* falcon, const SpaceMouseReading* spacemouse) {
  if (const OffReasonEntry& reason = entry_of(motors.reason); reason.is_safety_limit) {
    return {ExitCode::safety_stop, fmt::format("The motors went off ({}). {}", reason.title, reason.remedy)};
  }
  if (falcon != nullptr) return end_with(*falcon);
  if (spacemouse != nullptr) return end_with(spacemouse->trouble);
  return {};
}

}  // namespace ghostforce
