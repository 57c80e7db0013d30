#include "app/live/portable_inputs.h"

#include "app/live/pointer_link.h"
#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"

namespace ghostforce {

std::vector<InputEntry> portable_inputs(const ReadinessOf& readiness_of) {
  return {
      linked<PointerLink>(mouse_kind),    linked<InputLink>(script_kind),
      linked<InputLink>(replay_kind),     circle_entry(),
      virtual_falcon_entry(readiness_of),
  };
}

}  // namespace ghostforce
