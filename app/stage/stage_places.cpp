#include "app/stage/stage_places.h"

#include <algorithm>
#include <optional>

namespace ghostforce {

bool is_in_sight(const StageLayout& layout, const Vector<2>& place) {
  // Nor to their left, up to the edge.
  const auto is_beside = [&](const std::optional<ScreenBox>& box) {
    return box && place.x <= box->most.x && place.y >= box->least.y && place.y <= box->most.y;
  };
  return !is_beside(layout.numbers) && !is_beside(layout.tools_box()) && !is_beside(layout.motors_box()) &&
         contains(layout.scene(), place);
}

double strategy_button_width(const StrategyWords& words, double unit, const StageLetters& letters,
                             const MeasureText& measure) {
  constexpr double around = 96.0;  // key, shape and space [points of the design]
  return around * unit + std::max(measure(words.name, letters.bold_words).x, measure(words.about, letters.about).x);
}

}  // namespace ghostforce
