#include "app/view/stage/stage_mode.h"

#include <algorithm>
#include <array>

namespace ghostforce {
namespace {

constexpr std::array modes{
    StageModeEntry{StageMode::predict, "predict", "Q", "Predict", "Guess where the handle comes to rest."},
    StageModeEntry{StageMode::why, "why", "Y", "Why?", "Where the ghost force comes from, in four steps."},
    StageModeEntry{StageMode::landscape, "landscape", "L", "Landscape",
                   "How strong the ghost force is, for every wall and hand."},
    StageModeEntry{StageMode::round, "round", "O", "Round and round",
                   "How much energy the wall gives to a hand that circles in it."},
    StageModeEntry{StageMode::ribbon, "ribbon", "H", "Last minute", "Look again at what has just happened."},
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
