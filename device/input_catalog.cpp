#include "device/input_catalog.h"

#include "device/input/circle_input.h"
#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"
#include "device/virtual_falcon/virtual_falcon_input.h"

namespace ghostforce {

const InputMaker<MouseInput> mouse_kind{
    {mouse_hand}, [](const Scene&, const InputOptions&) { return std::make_unique<MouseInput>(); }};

const InputMaker<ScriptedInput> script_kind{
    {scripted_hand, /*is_scripted=*/true},
    [](const Scene& scene, const InputOptions&) { return std::make_unique<ScriptedInput>(scene.goal); }};

const InputMaker<ScriptedInput> replay_kind{
    {replayed_hand,
     /*is_scripted=*/true,
     /*needs_recording=*/true},
    [](const Scene& scene, const InputOptions& options) {
      return std::make_unique<ScriptedInput>(options.recorded_hand ? *options.recorded_hand : scene.goal);
    }};

const InputMaker<CircleInput> circle_kind{
    {circling_hand}, [](const Scene& scene, const InputOptions&) {
      return std::make_unique<CircleInput>(circle_inside(wall_of(scene.settings), scene.goal.points.back(), {}));
    }};

const InputMaker<VirtualFalconInput> virtual_falcon_kind{
    {{"virtual-falcon", "Virtual Falcon",
      "The Falcon's driver with a simulated device and hand behind it; drag in the scene to guide that hand."},
     /*is_scripted=*/false,
     /*needs_recording=*/false,
     /*hand_is_simulated=*/true},
    [](const Scene& scene, const InputOptions& options) {
      return std::make_unique<VirtualFalconInput>(options.falcon, options.injected_fault, scene,
                                                  options.virtual_falcon_clock);
    }};

}  // namespace ghostforce
