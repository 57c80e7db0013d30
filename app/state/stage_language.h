// StageLanguage: all words of the stage, of lessons and of the palette that are the program's own, in one language.
// Immutable, any thread. The build makes the struct and its tables of assets/languages (cmake/languages.py): a table
// there is a struct here, a key a std::string_view, and a language is one file. english_stage and spanish_stage are
// named after their files.
//
// "{}" stands for a number or a name that is put in. Numbers keep their decimal point and their units in all languages.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "core/safety.h"
#include "core/strategy.h"
#include "embedded_languages.h"

namespace ghostforce {

static_assert(std::is_same_v<decltype(StageLanguage::strategy_buttons), PerStrategy<StageLanguage::StrategyButton>>,
              "assets/languages: each strategy has a button");
static_assert(std::tuple_size_v<decltype(StageLanguage::Motors::reasons)> ==
                  static_cast<std::size_t>(OffReason::fault) + 1,
              "assets/languages: motors have a word for each reason to be off");
static_assert(std::tuple_size_v<decltype(StageLanguage::Motors::waits)> ==
                  static_cast<std::size_t>(ArmingObstacle::focus),
              "assets/languages: motors have a sentence for each thing that arming waits for");

// English for a language that is not there.
const StageLanguage& stage_language(std::string_view code) noexcept;

// What the button of a strategy says; `about` is empty where there is room for the name alone.
struct StrategyWords {
  std::string_view name;
  std::string_view about;
};
// Of a device with strings, or with motors that push.
StrategyWords strategy_words(const StageLanguage& language, StrategyId id, bool has_strings) noexcept;

// All entries of a table, or of a part of one, in their order.
template <typename Table>
auto words_of(const Table& table) noexcept {
  return std::bit_cast<std::array<std::string_view, sizeof(Table) / sizeof(std::string_view)>>(table);
}

// What a language has in place of these words of the English table; these themselves where it is not of that table.
template <typename Table>
std::string_view counterpart(const Table& english, const Table& own, std::string_view words) noexcept {
  const auto all = words_of(english);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] == words) return words_of(own)[i];
  }
  return words;
}

// The words with these values in place of "{}".
template <typename... Values>
std::string filled(std::string_view words, const Values&... values) {
  return fmt::format(fmt::runtime(words), values...);
}

// Of what is on a button, "Enter: next step", for whoever has no such key or is elsewhere: "Next step".
inline std::string without_key(std::string_view words) {
  const std::size_t end = words.find(": ");
  if (end == std::string_view::npos) return std::string(words);
  std::string rest(words.substr(end + 2));
  if (!rest.empty() && rest.front() >= 'a' && rest.front() <= 'z')
    rest.front() = static_cast<char>(rest.front() - 'a' + 'A');
  return rest;
}

}  // namespace ghostforce
