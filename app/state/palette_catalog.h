// The palette's catalog: every Action that a person finds by its words, in their language, with its key and with why it
// cannot be done at the moment. Pure; UI thread.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/state/action.h"
#include "app/state/stage_language.h"

namespace ghostforce {

struct PaletteEntry {
  std::string words;
  std::string_view also;  // further words by which it is found
  std::string key;        // as printed on it; empty: it has none
  Action action;
  std::string refusal;  // a sentence; empty: it can be done
};

// Of this front, as things are.
std::vector<PaletteEntry> palette_catalog(const Session& session, const LoopReading& loop);

}  // namespace ghostforce
