#include "app/cli/desktop_inputs.h"

#include <algorithm>

#include "app/cli/spacemouse_input_link.h"
#include "app/doctor/readiness.h"
#include "app/live/portable_inputs.h"
#include "device/falcon/falcon_input.h"
#include "device/spacemouse_hid/hid_spacemouse_input.h"

namespace ghostforce {
namespace {

const InputMaker<SpaceMouseInput> spacemouse_kind{
    {{"spacemouse", "SpaceMouse", "The goal follows the cap of a 3Dconnexion SpaceMouse."}},
    [](const Scene&, const InputOptions&) { return std::make_unique<HidSpaceMouseInput>(); }};

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
  std::vector<InputEntry> inputs = portable_inputs(readiness_with_motors);
  // A rehearsal comes after the device that it rehearses.
  const auto rehearsal =
      std::ranges::find_if(inputs, [](const InputEntry& entry) { return entry.name == virtual_falcon_kind.name; });
  inputs.insert(rehearsal, {linked<SpaceMouseInputLink>(spacemouse_kind),
                            falcon_entry(falcon_kind(cable), readiness_with_motors)});
  return inputs;
}

}  // namespace ghostforce
