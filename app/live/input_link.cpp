#include "app/live/input_link.h"

#include <algorithm>

#include "app/live/circle_input_link.h"
#include "app/live/falcon_input_link.h"
#include "app/live/pointer_link.h"
#include "device/input/mouse_input.h"
#include "device/input/scripted_input.h"

namespace ghostforce {

std::vector<InputEntry> portable_inputs(const LadderOf& ladder_of) {
  return {
      linked<PointerLink>(mouse_kind),
      linked<InputLink>(script_kind),
      linked<InputLink>(replay_kind),
      linked<CircleInputLink>(circle_kind),
      linked<VirtualFalconInputLink>(virtual_falcon_kind, ladder_of),
  };
}

const InputEntry* find_input(std::span<const InputEntry> inputs, std::string_view name) noexcept {
  const auto found = std::ranges::find(inputs, name, &InputEntry::name);
  return found == inputs.end() ? nullptr : &*found;
}

std::vector<InputChoice> choices_of(std::span<const InputEntry> inputs, bool has_recording) {
  std::vector<InputChoice> choices;
  for (const InputEntry& entry : inputs) {
    if (has_recording || !entry.needs_recording) choices.push_back(entry);
  }
  return choices;
}

}  // namespace ghostforce
