#include "app/stage/stage_places.h"

#include <algorithm>

namespace ghostforce {

bool is_in_sight(const StageLayout& layout, const Vector<2>& place) {
  const auto tools = layout.tools_box();
  const bool is_covered = (layout.numbers && contains(*layout.numbers, place)) || (tools && contains(*tools, place));
  return !is_covered && contains(layout.scene(), place);
}

double strategy_button_width(const StrategyWords& words, double unit, const StageLetters& letters,
                             const MeasureText& measure) {
  constexpr double around = 96.0;  // key, shape and space [points of the design]
  return around * unit + std::max(measure(words.name, letters.bold_words).x, measure(words.about, letters.about).x);
}

}  // namespace ghostforce
