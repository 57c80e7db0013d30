#include "app/state/faces_and_modes.h"

#include <algorithm>

namespace ghostforce {
namespace {

constexpr std::array modes{
    StageModeEntry{StageMode::predict, "predict", "Q", false, &StageLanguage::Modes::predict},
    StageModeEntry{StageMode::why, "why", "Y", false, &StageLanguage::Modes::why},
    StageModeEntry{StageMode::landscape, "landscape", "L", true, &StageLanguage::Modes::landscape},
    StageModeEntry{StageMode::round, "round", "O", true, &StageLanguage::Modes::round},
    StageModeEntry{StageMode::ribbon, "ribbon", "H", true, &StageLanguage::Modes::ribbon},
    StageModeEntry{StageMode::measure, "measure", "S", true, &StageLanguage::Modes::measure},
};

}  // namespace

std::span<const StageModeEntry> stage_mode_catalog() noexcept {
  return modes;
}

std::optional<StageMode> find_stage_mode(std::string_view name) noexcept {
  const auto* const found = std::ranges::find(modes, name, &StageModeEntry::name);
  return found == modes.end() ? std::nullopt : std::optional(found->id);
}

std::string_view stage_mode_name(StageMode id) noexcept {
  const auto* const found = std::ranges::find(modes, id, &StageModeEntry::id);
  return found == modes.end() ? "none" : found->name;
}

}  // namespace ghostforce
