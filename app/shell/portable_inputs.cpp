#include "app/shell/portable_inputs.h"

#include "app/shell/pointer_link.h"
#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"

namespace ghostforce {

std::vector<InputEntry> portable_inputs(const ReadinessOf& readiness_of, const std::vector<InputEntry>& devices) {
  std::vector<InputEntry> inputs{linked<PointerLink>(mouse_kind), linked<InputLink>(script_kind),
                                 linked<InputLink>(replay_kind), circle_entry()};
  inputs.insert(inputs.end(), devices.begin(), devices.end());
  inputs.push_back(virtual_falcon_entry(readiness_of));
  return inputs;
}

}  // namespace ghostforce
