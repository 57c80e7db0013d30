// A position as people type it: "25,-10", in mm. Pure, any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/scene.h"

namespace ghostforce {

// [m]; empty: it is not a position that a scene may hold.
std::optional<Vector<2>> read_position_mm(std::string_view text);

// "TEXT: not a position; give …, as in OPTION=-10,5"
std::string no_position_words(std::string_view option, std::string_view text);

// Reads back bit for bit where the position came from a file or from rounded_to_file().
std::string position_mm_text(const Vector<2>& position);

}  // namespace ghostforce
