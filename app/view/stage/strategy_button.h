// The buttons of the three strategies: their words and how wide they are. Pure, any thread.
#pragma once

#include <span>
#include <string_view>

#include "app/view/stage/stage_places.h"

namespace ghostforce {

struct StrategyButtonWords {
  StrategyId id;
  std::string_view in_full;
  std::string_view in_short;
};
std::span<const StrategyButtonWords> strategy_button_words() noexcept;

// With its key and the strategy's shape before the words [points].
double strategy_button_width(std::string_view words, double unit, const StageLetters& letters,
                             const MeasureText& measure);

}  // namespace ghostforce
