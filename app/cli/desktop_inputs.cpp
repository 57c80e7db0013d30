#include "app/cli/desktop_inputs.h"

#include "app/doctor/readiness.h"
#include "app/live/portable_inputs.h"
#include "app/live/spacemouse_input_link.h"
#include "device/falcon/falcon_input.h"
#include "device/spacemouse_hid/hid_spacemouse_input.h"

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

}  // namespace ghostforce
