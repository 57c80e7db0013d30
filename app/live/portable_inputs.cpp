#include "app/live/portable_inputs.h"

#include "app/live/circle_input_link.h"
#include "app/live/pointer_link.h"
#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"

namespace ghostforce {

std::vector<InputEntry> portable_inputs(const ReadinessOf& readiness_of) {
  return {
      linked<PointerLink>(mouse_kind),
      linked<InputLink>(script_kind),
      linked<InputLink>(replay_kind),
      linked<CircleInputLink>(circle_kind),
      linked<VirtualFalconInputLink>(virtual_falcon_kind, readiness_of),
  };
}

}  // namespace ghostforce
