#include "app/files/kept_text.h"

#include <sstream>

#include <fmt/format.h>

#include "app/files/toml_parse.h"

namespace ghostforce {
namespace {

constexpr std::string_view kept_format_name = "format";
constexpr int kept_format = 1;

}  // namespace

std::string kept_beginning(std::string_view comment) {
  return fmt::format("# Written by ghostforce: {}\n{} = {}\n", comment, kept_format_name, kept_format);
}

bool is_of_newer_format(std::string_view text) {
  const toml::table table = parse_toml(text).table;
  return table[kept_format_name].value_or(kept_format) > kept_format;
}

std::string damage_words(const std::vector<ReadProblem>& problems) {
  std::string damage;
  for (const ReadProblem& problem : problems) {
    if (!damage.empty()) damage += "; ";
    if (problem.line > 0) damage += fmt::format("line {}: ", problem.line);
    damage += words_of({.what = problem.what, .remedy = problem.remedy});
  }
  return damage;
}

std::string without_named_keys(std::string_view text, std::span<const std::string_view> keys) {
  toml::table table = parse_toml(text).table;
  table.erase(kept_format_name);
  for (const std::string_view key : keys) table.erase(key);
  if (table.empty()) return {};
  std::ostringstream others;
  others << toml::toml_formatter(table) << '\n';
  return others.str();
}

}  // namespace ghostforce
