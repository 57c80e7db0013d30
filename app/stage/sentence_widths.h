// SentenceWidths: how wide all is that may stand where a language's sentence does, in two sizes of letters. It is
// measured once, until language or letters are others. One thread.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "app/picture/text.h"
#include "app/state/stage_language.h"

namespace ghostforce {

// Its sentences, so many, and then its warnings.
inline constexpr std::size_t sentence_count = sizeof(StageLanguage::Sentences) / sizeof(std::string_view);
std::vector<std::string_view> all_said_there(const StageLanguage& language);

class SentenceWidths {
 public:
  // Of all of these, in their order [points]. Good until the next call but one.
  const std::vector<double>& of(const StageLanguage& language, const TextStyle& style, const MeasureText& measure);

 private:
  struct Measured {
    const StageLanguage* language = nullptr;
    TextStyle style{};
    std::vector<double> widths{};
  };
  std::array<Measured, 2> measured_{};
};

}  // namespace ghostforce
