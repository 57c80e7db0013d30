#include "app/base/language.h"

#include <gtest/gtest.h>

namespace ghostforce::language_test {
namespace {

TEST(LanguageCode, IsTwoSmallLetters) {
  EXPECT_TRUE(is_language_code("es"));
  for (const std::string_view text : {"", "e", "spa", "ES", "e1", "es_ES", "\xc3\xa9"}) {
    EXPECT_FALSE(is_language_code(text)) << text;
  }
}

TEST(WantedLanguage, IsTheFirstThatAnythingNames) {
  EXPECT_EQ(wanted_language("", {}), "en");
  EXPECT_EQ(wanted_language("", {.lang = "es_ES.UTF-8"}), "es");
  EXPECT_EQ(wanted_language("", {.messages = "de", .lang = "es_ES.UTF-8"}), "de");
  EXPECT_EQ(wanted_language("", {.all = "fr_CA@euro", .messages = "de", .lang = "es"}), "fr");
  EXPECT_EQ(wanted_language("es", {.all = "fr_CA", .messages = "de", .lang = "pt"}), "es");
  EXPECT_EQ(wanted_language("es-MX", {}), "es");
}

TEST(WantedLanguage, IsEnglishWhereALocaleNamesNone) {
  for (const std::string_view locale : {"C", "C.UTF-8", "POSIX", "e", "ES", "spanish", "\xff\xff", "_es", "."}) {
    EXPECT_EQ(wanted_language("", {.lang = locale}), "en") << locale;
  }
  EXPECT_EQ(wanted_language("", {.all = "C", .lang = "es_ES.UTF-8"}), "en")
      << "LC_ALL comes first, as for every program";
}

}  // namespace
}  // namespace ghostforce::language_test
