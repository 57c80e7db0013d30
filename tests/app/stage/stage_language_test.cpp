// The tables of words. That nothing is missing in any language is seen to by the build (languages_test.py).
#include "app/state/stage_language.h"

#include <algorithm>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "app/stage/landscape_words.h"

namespace ghostforce::stage_language_test {
namespace {

std::size_t places_in(std::string_view words) {
  std::size_t count = 0;
  for (std::size_t at = words.find("{}"); at != std::string_view::npos; at = words.find("{}", at + 2)) ++count;
  return count;
}

// Other marks would be read as formats.
TEST(StageLanguage, HasNoMarksButThePlacesOfWhatIsPutIn) {
  std::set<std::string_view> codes;
  for (const StageLanguage* const language : stage_languages) {
    SCOPED_TRACE(language->code);
    EXPECT_EQ(language->code.size(), 2U);
    EXPECT_TRUE(codes.insert(language->code).second);
    for (const std::string_view words : words_of(*language)) {
      const auto braces = std::ranges::count_if(words, [](char letter) { return letter == '{' || letter == '}'; });
      EXPECT_EQ(static_cast<std::size_t>(braces), 2 * places_in(words)) << words;
    }
  }
  EXPECT_GT(codes.size(), 1U);
}

// Two sentences with the same words would be two claims that nobody can tell apart.
TEST(StageLanguage, HasASentenceOfItsOwnForEachClaim) {
  for (const StageLanguage* const language : stage_languages) {
    std::set<std::string_view> seen;
    for (const std::string_view words : words_of(language->sentences)) EXPECT_TRUE(seen.insert(words).second) << words;
  }
}

// Somebody has written all of it anew: what is left as in English is a name, or a word that both have.
TEST(StageLanguage, IsTranslated) {
  const std::set<std::string_view> shared{"motor", "Motor", "Motor 1", "Motor 2", "{} ({} N·m)"};
  const auto english = words_of(english_stage);
  const auto spanish = words_of(spanish_stage);
  for (std::size_t i = 0; i < english.size(); ++i) {
    EXPECT_TRUE(english[i] != spanish[i] || shared.contains(english[i])) << english[i];
  }
}

TEST(StageLanguage, IsEnglishWhereThereIsNoOther) {
  EXPECT_EQ(&stage_language("es"), &spanish_stage);
  EXPECT_EQ(&stage_language("en"), &english_stage);
  for (const std::string_view code : {"", "xx", "ES", "español"}) EXPECT_EQ(&stage_language(code), &english_stage);
}

// The motors' own words in English are the workbench's.
TEST(StageLanguage, NamesEachReasonOfTheMotors) {
  ASSERT_EQ(off_reason_catalog().size(), english_stage.motors.reasons.size());
  for (const OffReasonEntry& entry : off_reason_catalog()) {
    EXPECT_EQ(english_stage.motors.reasons[static_cast<std::size_t>(entry.id)], entry.title);
  }
}

// Several ways to break the same words.
TEST(StageLanguage, BreaksWordsOfTheMapWithoutChangingThem) {
  EXPECT_EQ(line_breaks_of("a b|a\nb"), (LineBreaks{{"a b"}, {"a", "b"}}));
  for (const StageLanguage* const language : stage_languages) {
    for (const std::string_view words : words_of(language->map)) {
      std::set<std::string> joined;
      for (const auto& way : line_breaks_of(words)) {
        std::string all;
        for (const std::string& line : way) all.append(all.empty() ? "" : " ").append(line);
        joined.insert(all);
      }
      EXPECT_EQ(joined.size(), 1U) << words;
    }
  }
}

}  // namespace
}  // namespace ghostforce::stage_language_test
