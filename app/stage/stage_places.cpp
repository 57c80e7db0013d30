#include "app/stage/stage_places.h"

namespace ghostforce {

double strategy_button_width(std::string_view words, double unit, const StageLetters& letters,
                             const MeasureText& measure) {
  constexpr double around = 96.0;  // key, shape and space [points of the design]
  return around * unit + measure(words, letters.bold_words).x;
}

}  // namespace ghostforce
