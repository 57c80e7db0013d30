// The language that a person wants to read. Pure, any thread.
#pragma once

#include <string>
#include <string_view>

namespace ghostforce {

// Two small letters, as ISO 639-1 has them, whether or not any language has these.
bool is_language_code(std::string_view text) noexcept;

// What setlocale(3) would look at, in its order; empty: not set.
struct LocaleVariables {
  std::string_view all{};       // LC_ALL
  std::string_view messages{};  // LC_MESSAGES
  std::string_view lang{};      // LANG
};

// Its code of ISO 639-1: "es" for es_ES.UTF-8. What was asked for (--language) comes before the environment; "en" where
// nothing is known.
std::string wanted_language(std::string_view asked_for, const LocaleVariables& environment);

// The environment of this process.
LocaleVariables locale_variables();

}  // namespace ghostforce
