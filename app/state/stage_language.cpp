#include "app/state/stage_language.h"

#include <algorithm>

namespace ghostforce {

const StageLanguage& stage_language(std::string_view code) noexcept {
  const auto found = std::ranges::find(stage_languages, code, &StageLanguage::code);
  return found == stage_languages.end() ? *stage_languages.front() : **found;
}

StrategyWords strategy_words(const StageLanguage& language, StrategyId id, bool has_strings) noexcept {
  const StageLanguage::StrategyButton& words = language.strategy_buttons[index_of(id)];
  return {.name = words.name, .about = has_strings ? words.about_with_strings : words.about};
}

}  // namespace ghostforce
