#include "app/base/language.h"

#include <algorithm>
#include <cstdlib>

namespace ghostforce {
namespace {

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view{} : value;
}

// "es" of "es", "es_ES.UTF-8" and "es@euro"; empty: of "C", "POSIX" and what is no locale.
std::string_view language_of(std::string_view locale) noexcept {
  const std::string_view language = locale.substr(0, locale.find_first_of("_-.@"));
  return is_language_code(language) ? language : std::string_view{};
}

}  // namespace

bool is_language_code(std::string_view text) noexcept {
  return text.size() == 2 && std::ranges::all_of(text, [](char c) { return c >= 'a' && c <= 'z'; });
}

std::string wanted_language(std::string_view asked_for, const LocaleVariables& environment) {
  for (const std::string_view locale : {asked_for, environment.all, environment.messages, environment.lang}) {
    if (locale.empty()) continue;
    const std::string_view language = language_of(locale);
    return language.empty() ? "en" : std::string(language);
  }
  return "en";
}

LocaleVariables locale_variables() {
  return {variable("LC_ALL"), variable("LC_MESSAGES"), variable("LANG")};
}

}  // namespace ghostforce
