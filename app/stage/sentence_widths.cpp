#include "app/stage/sentence_widths.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ghostforce {

std::vector<std::string_view> all_said_there(const StageLanguage& language) {
  std::vector<std::string_view> all;
  std::ranges::copy(words_of(language.sentences), std::back_inserter(all));
  std::ranges::copy(words_of(language.warnings), std::back_inserter(all));
  return all;
}

const std::vector<double>& SentenceWidths::of(const StageLanguage& language, const TextStyle& style,
                                              const MeasureText& measure) {
  const auto is_this = [&](const Measured& each) { return each.language == &language && each.style == style; };
  if (is_this(measured_[0])) return measured_[0].widths;
  std::swap(measured_[0], measured_[1]);
  if (is_this(measured_[0])) return measured_[0].widths;
  measured_[0] = {&language, style, {}};
  for (const std::string_view text : all_said_there(language)) {
    measured_[0].widths.push_back(measure(text, style).x);
  }
  return measured_[0].widths;
}

}  // namespace ghostforce
