#include "app/view/stage/strategy_button.h"

#include <array>

namespace ghostforce {
namespace {

constexpr std::array button_words{
    StrategyButtonWords{StrategyId::full, "Two motors", "Two motors"},
    StrategyButtonWords{StrategyId::naive, "One motor, naïve", "Naïve"},
    StrategyButtonWords{StrategyId::anisotropic, "One motor, anisotropic", "Anisotropic"},
};

}  // namespace

std::span<const StrategyButtonWords> strategy_button_words() noexcept {
  return button_words;
}

double strategy_button_width(std::string_view words, double unit, const StageLetters& letters,
                             const MeasureText& measure) {
  constexpr double around = 96.0;  // key, shape and space [points of the design]
  return around * unit + measure(words, letters.bold_words).x;
}

}  // namespace ghostforce
