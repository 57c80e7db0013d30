#include "app/files/scene_override.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "app/console/quoted.h"
#include "app/files/scene_keys.h"
#include "app/files/toml_text.h"

namespace ghostforce {
namespace {

std::string_view trimmed(std::string_view text) noexcept {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::optional<toml::table> parse_toml_value(std::string_view value) {
  ParsedToml parsed = parse_toml(fmt::format("value = {}\n", value));
  // A line break in the value could have begun another key.
  if (parsed.problem || parsed.table.size() != 1) return std::nullopt;
  return std::move(parsed.table);
}

bool is_word(std::string_view value) noexcept {
  return std::all_of(value.begin(), value.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_'; });
}

// Where only a text is possible, whatever comes without quotes is one, 42 too; elsewhere a single word is.
std::optional<toml::table> parse_value(bool holds_text, std::string_view value) {
  const bool is_quoted = value.starts_with('"') || value.starts_with('\'');
  if (holds_text && !is_quoted) return parse_toml_value(toml_string(value));
  if (value.empty()) return std::nullopt;
  if (std::optional<toml::table> parsed = parse_toml_value(value)) return parsed;
  return is_word(value) ? parse_toml_value(toml_string(value)) : std::nullopt;
}

}  // namespace

std::variant<SceneOverride, std::string> parse_override(std::string_view argument) {
  const std::size_t equals = argument.find('=');
  const std::string_view name = trimmed(argument.substr(0, equals));
  if (equals == std::string_view::npos || name.empty()) return "give KEY=VALUE, for example rendering.k_r_N_per_m=800";

  const SceneKey* const key = find_scene_key(name);
  if (key == nullptr && name != "format") {
    return fmt::format("the key {} is unknown{}", printable(name), suggest_scene_key(name));
  }
  const bool holds_text =
      key != nullptr && (std::holds_alternative<TextKey>(key->value) || std::holds_alternative<ChoiceKey>(key->value));
  const std::string_view value = trimmed(argument.substr(equals + 1));
  std::optional<toml::table> parsed = parse_value(holds_text, value);
  if (!parsed) {
    return fmt::format("the key {}: {} is no value; give {}", name, value.empty() ? "nothing" : printable(value),
                       holds_text ? "a text in UTF-8" : "a number such as 1.5, inf, or an array such as [0.0, 10.0]");
  }
  return SceneOverride{std::string(name), std::move(*parsed)};
}

}  // namespace ghostforce
