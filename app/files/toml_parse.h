// TOML by toml++, without falling over what toml++ falls over. Only those include this who need its nodes: toml++ takes
// long to compile. Pure, any thread.
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

}  // namespace ghostforce
