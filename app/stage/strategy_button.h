// The buttons of the three strategies: how wide they are. Pure, any thread.
#pragma once

#include <string_view>

#include "app/stage/stage_places.h"

namespace ghostforce {

// With its key and the strategy's shape before the words [points].
double strategy_button_width(std::string_view words, double unit, const StageLetters& letters,
                             const MeasureText& measure);

}  // namespace ghostforce
