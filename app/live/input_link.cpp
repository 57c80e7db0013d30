#include "app/live/input_link.h"

#include <algorithm>

namespace ghostforce {

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
