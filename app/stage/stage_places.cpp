#include "app/stage/stage_places.h"

#include <algorithm>

namespace ghostforce {

double strategy_button_width(const StrategyWords& words, double unit, const StageLetters& letters,
                             const MeasureText& measure) {
  constexpr double around = 96.0;  // key, shape and space [points of the design]
  return around * unit + std::max(measure(words.name, letters.bold_words).x, measure(words.about, letters.about).x);
}

}  // namespace ghostforce
