#include "app/files/kept_text.h"

#include <sstream>

#include <fmt/format.h>

#include "app/files/toml_parse.h"

namespace ghostforce {

std::string damage_words(const std::vector<ReadProblem>& problems) {
  std::string damage;
  for (const ReadProblem& problem : problems) {
    if (!damage.empty()) damage += "; ";
    if (problem.line > 0) damage += fmt::format("line {}: ", problem.line);
    damage += words_of({.what = problem.what, .remedy = problem.remedy});
  }
  return damage;
}

std::string without_keys(std::string_view text, std::span<const std::string_view> keys) {
  toml::table table = parse_toml(text).table;
  for (const std::string_view key : keys) table.erase(key);
  if (table.empty()) return {};
  std::ostringstream others;
  others << toml::toml_formatter(table) << '\n';
  return others.str();
}

}  // namespace ghostforce
