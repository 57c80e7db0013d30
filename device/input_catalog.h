// The catalog of inputs that need nothing but this program: no cable, no thread of their own. A new one is its own file
// and one row here; the desktop's other inputs are in app/cli/desktop_inputs.h. app/shell/input_link.h says what the
// window does with each. Immutable after start, any thread; making an input allocates and may throw.
#pragma once

#include <functional>
#include <memory>

#include "core/scene.h"
#include "device/falcon/falcon.h"
#include "device/input/input.h"
#include "device/report/input_choice.h"
#include "device/virtual_falcon/virtual_link.h"

namespace ghostforce {

class CircleInput;
class MouseInput;
class ScriptedInput;
class VirtualFalconInput;

// What making an input may need besides the scene.
struct InputOptions {
  FalconOptions falcon;
  InjectedFault injected_fault;  // of the virtual Falcon
  VirtualLink::Clock virtual_falcon_clock = VirtualLink::Clock::monotonic;
  std::shared_ptr<const GoalPath>
      recorded_hand{};  // what replay replays; null: none is loaded, replay the scene's path
};

struct InputKind : InputChoice {
  bool is_scripted = false;        // gives the same goal at the same tick in each run, and starts where its path does
  bool needs_recording = false;    // InputOptions::recorded_hand
  bool hand_is_simulated = false;  // though it has motors: a rehearsal
};

// A kind, and how one is made of it: as the class that it is.
template <typename Made>
struct InputMaker : InputKind {
  std::function<std::unique_ptr<Made>(const Scene&, const InputOptions&)> make;
};

extern const InputMaker<MouseInput> mouse_kind;
extern const InputMaker<ScriptedInput> script_kind;
extern const InputMaker<ScriptedInput> replay_kind;
extern const InputMaker<CircleInput> circle_kind;
extern const InputMaker<VirtualFalconInput> virtual_falcon_kind;

}  // namespace ghostforce
