#include "app/view/stage/stage_language.h"

#include <algorithm>

namespace ghostforce {

std::span<const StageLanguage* const> stage_language_catalog() noexcept {
  static constexpr std::array all{&english_stage, &spanish_stage};
  return all;
}

const StageLanguage& stage_language(std::string_view code) noexcept {
  const auto all = stage_language_catalog();
  const auto found = std::ranges::find(all, code, &StageLanguage::code);
  return found == all.end() ? *all.front() : **found;
}

}  // namespace ghostforce
