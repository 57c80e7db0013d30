#include "app/state/stage_language.h"

#include <algorithm>

namespace ghostforce {

const StageLanguage& stage_language(std::string_view code) noexcept {
  const auto found = std::ranges::find(stage_languages, code, &StageLanguage::code);
  return found == stage_languages.end() ? *stage_languages.front() : **found;
}

}  // namespace ghostforce
