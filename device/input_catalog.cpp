#include "device/input_catalog.h"

#include <algorithm>
#include <array>

#include "device/falcon/falcon_input.h"
#include "device/falcon_usb/ftdi_link.h"
#include "device/input/circle_input.h"
#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"
#include "device/spacemouse/spacemouse_input.h"
#include "device/virtual_falcon/virtual_falcon_input.h"

namespace ghostforce {
namespace {

std::unique_ptr<Input> make_mouse(const Scene&, const InputOptions&) {
  return std::make_unique<MouseInput>();
}

std::unique_ptr<Input> make_script(const Scene& scene, const InputOptions&) {
  return std::make_unique<ScriptedInput>(scene.goal);
}

std::unique_ptr<Input> make_replay(const Scene& scene, const InputOptions& options) {
  return std::make_unique<ScriptedInput>(options.recorded_hand ? *options.recorded_hand : scene.goal);
}

std::unique_ptr<Input> make_circle(const Scene& scene, const InputOptions&) {
  return std::make_unique<CircleInput>(circle_inside(wall_of(scene.settings), scene.goal.points.back(), {}));
}

std::unique_ptr<Input> make_spacemouse(const Scene&, const InputOptions&) {
  return std::make_unique<SpaceMouseInput>();
}

std::unique_ptr<Input> make_falcon(const Scene& scene, const InputOptions& options) {
  return std::make_unique<FalconInput>(
      std::make_unique<FtdiLink>(FtdiLinkOptions{.id = options.falcon_id, .serial = options.falcon_serial}),
      options.falcon, scene.view.center);
}

std::unique_ptr<Input> make_virtual_falcon(const Scene& scene, const InputOptions& options) {
  return std::make_unique<VirtualFalconInput>(options.falcon, options.misbehaviour, scene.view.center,
                                              scene.settings.impedances.k_u, options.virtual_falcon_clock);
}

constexpr std::array kinds{
    InputKind{"mouse", "Mouse", "Drag in the scene: the goal follows the pointer.", make_mouse},
    InputKind{"script", "Scripted hand", "The goal follows the scene's path, the same way every time.", make_script,
              true},
    InputKind{"replay", "Replay", "The goal follows the hand of a recording, the same way every time.", make_replay,
              true, true},
    InputKind{"circle", "Circle", "The goal goes round a circle inside the wall: the motion of the energy test.",
              make_circle},
    InputKind{"spacemouse", "SpaceMouse", "The goal follows the cap of a 3Dconnexion SpaceMouse.", make_spacemouse},
    InputKind{"falcon", "Falcon", "A Novint Falcon: its handle is the goal, and with its motors on it is the device.",
              make_falcon},
    InputKind{"virtual-falcon", "Virtual Falcon",
              "The Falcon's driver with a simulated device and hand behind it; drag in the scene to lead that hand.",
              make_virtual_falcon},
};

}  // namespace

std::span<const InputKind> input_catalog() noexcept {
  return kinds;
}

const InputKind* find_input(std::string_view name) noexcept {
  const auto found = std::ranges::find(kinds, name, &InputKind::name);
  return found == kinds.end() ? nullptr : &*found;
}

}  // namespace ghostforce
