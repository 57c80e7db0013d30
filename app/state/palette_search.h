// Finds what somebody types among the palette's entries. Pure; any thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/state/palette_catalog.h"

namespace ghostforce {

// The entries' numbers. Each word that was typed must occur, in small or large letters, with or without accents. The
// best match comes first, what can be done before what cannot, and then as in the catalog; without words, all.
std::vector<std::size_t> find_in_palette(std::span<const PaletteEntry> entries, std::string_view sought);

// In small letters without accents.
std::string folded(std::string_view text);

}  // namespace ghostforce
