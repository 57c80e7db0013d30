#include "app/shell/input_link.h"

#include <algorithm>
#include <utility>

#include "device/input/unsteady_input.h"

namespace ghostforce {

LinkedInput make_in_hand_of(const Scene& scene, const InputEntry& entry, const InputOptions& options) {
  LinkedInput made = entry.make(scene, options);
  if (entry.hand_is_simulated) return made;
  const bool is_recorded = entry.needs_recording && options.recorded_hand != nullptr;
  const bool has_own_tremor = is_recorded || made.input->haptic_device() != nullptr;
  made.input = in_hand_of(scene, std::move(made.input), has_own_tremor);
  return made;
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
