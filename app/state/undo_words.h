// What a step of undo changes, in words for the button that takes it.
#pragma once

#include <string>

#include "app/state/undo.h"

namespace ghostforce {

// "k_r", "the strategy and the wall's angle", "opening “A wall at 45 degrees”"; never empty.
std::string words_of_change(const UndoState& before, const UndoState& after);

}  // namespace ghostforce
