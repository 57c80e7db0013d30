#include "app/cli/desktop_inputs.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/shell/portable_inputs.h"
#include "app/shell/spacemouse_input_link.h"
#include "app/tools/doctor/readiness.h"
#include "core/safety.h"
#include "device/falcon/falcon_input.h"
#include "device/spacemouse/hid_spacemouse_input.h"

namespace ghostforce {
namespace {

const InputMaker<SpaceMouseInput> spacemouse_kind{
    {{spacemouse_hand}}, [](const Scene&, const InputOptions&) { return std::make_unique<HidSpaceMouseInput>(); }};

constexpr SpaceMouseWords spacemouse_words{
    .absent = "None is plugged in. The program keeps looking for one.",
    .not_allowed =
        "One is plugged in, but this user may not open it: run 'ghostforce doctor --install-udev' once, then plug it "
        "in again.",
    .not_opened = "One is plugged in, but it cannot be opened: is another program using it?"};

std::vector<ReadinessStepState> readiness_with_motors(const FalconReport& report, const MotorReport& motors) {
  return readiness_of(report, &motors);
}

}  // namespace

InputMaker<FalconInput> falcon_kind(const FtdiLinkOptions& cable) {
  return {{{"falcon", "Falcon", "A Novint Falcon: its handle is the goal, and with its motors on it is the device."}},
          [cable](const Scene& scene, const InputOptions& options) {
            return std::make_unique<FalconInput>(std::make_unique<FtdiLink>(cable), options.falcon, scene.view.center);
          }};
}

std::vector<InputEntry> desktop_inputs(const FtdiLinkOptions& cable) {
  return portable_inputs(readiness_with_motors, {linked<SpaceMouseInputLink>(spacemouse_kind, spacemouse_words),
                                                 falcon_entry(falcon_kind(cable), readiness_with_motors)});
}

std::vector<InputEntry> simulated_inputs() {
  return portable_inputs(readiness_with_motors);
}

EndOfRun end_of_run(const MotorReport& motors, std::span<const ReadinessStepState> readiness,
                        const EndOfRun& of_input) {
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
