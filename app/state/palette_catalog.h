// The palette's catalog: every Action that a person finds by its words, in their language, with its key and with why it
// cannot be done at the moment; and the search in it. Pure; UI thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/state/action.h"
#include "app/state/stage_language.h"

namespace ghostforce {

// What an action is about, what is used most first. In the order of the words in assets/languages.
enum class ActionGroup : std::uint8_t { strategies, stage, hand, view, files, devices, scenes, window };

inline constexpr std::size_t action_group_count = static_cast<std::size_t>(ActionGroup::window) + 1;
static_assert(sizeof(StageLanguage::ActionGroups) / sizeof(std::string_view) == action_group_count,
              "assets/languages: each group of actions has words");

// Of the rows of keys that stand under that heading of help.
ActionGroup action_group_of(std::string_view key_group) noexcept;

struct PaletteEntry {
  std::string words;
  std::string_view also;  // further words by which it is found
  std::string key;        // as printed on it; empty: it has none
  Action action;
  std::string refusal;  // a sentence; empty: it can be done
  ActionGroup group;
};

// Of this front, as things are.
std::vector<PaletteEntry> palette_catalog(const Session& session, const LoopReading& loop);

// Why that cannot be done as things are, or would change nothing: a sentence; empty: it can be done.
std::string palette_refusal(const Session& session, const LoopReading& loop, const Action& action);

// The numbers of the entries in which what somebody has typed is found. Each word must occur, in small or large
// letters, with or without accents. The best match comes first, what can be done before what cannot, and then as in the
// catalog; without words, all. Any thread.
std::vector<std::size_t> find_in_palette(std::span<const PaletteEntry> entries, std::string_view sought);

// In small letters without accents.
std::string folded(std::string_view text);

}  // namespace ghostforce
