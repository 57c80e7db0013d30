// What is found for what is typed, as values.
#include "app/state/palette_catalog.h"

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/scene_file.h"
#include "app/state/key_bindings.h"

namespace ghostforce::palette_search_test {
namespace {

using Numbers = std::vector<std::size_t>;

PaletteEntry named(std::string words, std::string_view also = {}, std::string refusal = {}) {
  return {std::move(words), also, {}, Quit{}, std::move(refusal), {}};
}

TEST(PaletteSearch, FoldsLettersAndAccents) {
  EXPECT_EQ(folded("Más PEQUEÑO, ÁÉÍÓÚ naïve"), "mas pequeno, aeiou naive");
  EXPECT_EQ(folded("ρ 5° …"), "ρ 5° …");
  EXPECT_EQ(folded("\xC3"), "\xC3") << "cut off";
}

TEST(PaletteSearch, TheBestMatchComesFirst) {
  const std::vector<PaletteEntry> entries{named("Unsaved work"), named("Open", "save load"), named("Quick save"),
                                          named("Save a picture"), named("Help")};
  EXPECT_EQ(find_in_palette(entries, "save"), (Numbers{3, 2, 1}));
  EXPECT_EQ(find_in_palette(entries, "SÁVE  "), (Numbers{3, 2, 1}));
  EXPECT_EQ(find_in_palette(entries, "saved"), Numbers{0}) << "within a word, where no word begins so";
  EXPECT_EQ(find_in_palette(entries, "pic sav"), Numbers{3}) << "all of them, in any order";
  EXPECT_EQ(find_in_palette(entries, "save quit"), Numbers{});
}

TEST(PaletteSearch, WhatCanBeDoneComesBeforeWhatCannot) {
  const std::vector<PaletteEntry> entries{named("Motor a", "", "No."), named("Motor b"), named("a motor", "", ""),
                                          named("Motor c")};
  EXPECT_EQ(find_in_palette(entries, "motor"), (Numbers{1, 3, 0, 2}));
  EXPECT_EQ(find_in_palette(entries, ""), (Numbers{1, 2, 3, 0})) << "all, as in the catalog";
}

TEST(PaletteSearch, FindsInBothLanguagesWhatPeopleLookFor) {
  struct Case {
    const char* language;
    const char* sought;
    ActionWords wanted;
  };
  using Name = StageLanguage::Actions;
  Session session = session_of(load_scene("wall45"));
  for (const Case& c :
       {Case{"en", "emergency", &Name::stop_motors}, Case{"en", "arm", &Name::arm_motors},
        Case{"en", "save", &Name::save_scene}, Case{"en", "screenshot", &Name::save_picture},
        Case{"en", "video", &Name::save_clip}, Case{"en", "xyzzy", nullptr}, Case{"en", "fault", &Name::device_status},
        Case{"en", "reset", &Name::restart}, Case{"en", "fullscreen", &Name::full_screen},
        Case{"en", "side by side", &Name::side_by_side}, Case{"en", "full screen", &Name::full_screen},
        Case{"en", "dark", &Name::dark_theme}, Case{"es", "motor", &Name::stop_motors},
        Case{"es", "guardar", &Name::save_scene}, Case{"es", "video", &Name::save_clip},
        Case{"es", "teclas", &Name::help}, Case{"es", "MAS PEQUENO", &Name::smaller_text}}) {
    session.language = c.language;
    const std::vector<PaletteEntry> entries = palette_catalog(session, {});
    const Numbers found = find_in_palette(entries, c.sought);
    if (c.wanted == nullptr) {
      EXPECT_TRUE(found.empty()) << c.sought;
      continue;
    }
    ASSERT_FALSE(found.empty()) << c.sought;
    EXPECT_EQ(entries[found.front()].words, (stage_language(c.language).actions.*c.wanted).words) << c.sought;
  }
}

TEST(PaletteSearch, FindsHowToHideTheNumbersByAnyOfTheseWords) {
  using Words = std::vector<const char*>;
  Session session = session_of(load_scene("wall45"));
  for (const auto& [language, all] :
       {std::pair{"en", Words{"number", "numbers", "hide", "ask"}},
        std::pair{"es", Words{"numero", "números", "ocultar", "esconder", "preguntar", "cifras"}}}) {
    session.language = language;
    const std::vector<PaletteEntry> entries = palette_catalog(session, {});
    for (const char* const sought : all) {
      const Numbers found = find_in_palette(entries, sought);
      ASSERT_FALSE(found.empty()) << sought;
      EXPECT_TRUE(std::holds_alternative<ToggleNumbers>(entries[found.front()].action)) << sought;
    }
  }
}

}  // namespace
}  // namespace ghostforce::palette_search_test
