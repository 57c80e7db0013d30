// TOML as text: reading it without falling over what toml++ falls over, and writing texts. Pure, any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace ghostforce {

// What toml::parse() says, and where.
struct TomlProblem {
  toml::source_position position;
  std::string what;
};

// Either the table, or the problem.
struct ParsedToml {
  toml::table table;
  std::optional<TomlProblem> problem;
};
ParsedToml parse_toml(std::string_view text);

// What a person calls a value of this type: "a text", "a table".
std::string_view type_words(toml::node_type type) noexcept;

// A text as TOML writes it: in double quotes, on one line.
std::string toml_string(std::string_view text);

}  // namespace ghostforce
