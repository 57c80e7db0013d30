#include "app/files/toml_parse.h"

#include <array>
#include <string>
#include <string_view>

#include "app/base/quoted.h"

namespace ghostforce {
namespace {

// toml++ builds and destroys a name a.b.c… of any length by recursion, one call per dot, and would run out of stack.
// Nobody needs a name of this many.
constexpr int most_dots = 256;

constexpr std::size_t longest_description = 400;

// What the library says, and what a person has to do about it. Its position is where it noticed.
struct PlainWords {
  std::string_view library;  // a part of its words
  std::string_view plain;
};
constexpr std::array plain_words{
    PlainWords{"unescaped control characters", "a text in quotes does not end on its line; add the closing quote"},
    PlainWords{"expected comma or closing ']'", "an array before this place has no end; add a comma or a ]"},
};

std::string plain(std::string_view description) {
  for (const PlainWords& words : plain_words) {
    if (description.find(words.library) != std::string_view::npos) return std::string(words.plain);
  }
  return quoted_text(description, longest_description);
}

// Looks at each line for itself: a name never spans lines. What it takes for a name inside a text of several lines is
// none, and would need as many dots.
std::optional<TomlProblem> find_too_many_dots(std::string_view text) {
  toml::source_position position{1, 1};
  int dots = 0;
  char quote = 0;  // that is open
  bool is_comment = false;
  bool is_escaped = false;
  for (const char c : text) {
    if (c == '\n') {
      ++position.line;
      position.column = 0;
      dots = 0;
      quote = 0;
      is_comment = false;
      is_escaped = false;
    } else if (quote != 0) {
      if (!is_escaped && c == quote) quote = 0;
      is_escaped = !is_escaped && c == '\\' && quote == '"';
    } else if (c == '"' || c == '\'') {
      quote = is_comment ? '\0' : c;
    } else if (c == '#') {
      is_comment = true;
    } else if (c == ',' || c == '=') {
      dots = 0;
    } else if (c == '.' && !is_comment && ++dots > most_dots) {
      return TomlProblem{position, "this name has too many dots"};
    }
    ++position.column;
  }
  return std::nullopt;
}

}  // namespace

ParsedToml parse_toml(std::string_view text) {
  if (auto problem = find_too_many_dots(text)) return {{}, std::move(problem)};
  try {
    return {toml::parse(text), std::nullopt};
  } catch (const toml::parse_error& error) {
    return {{}, TomlProblem{error.source().begin, plain(error.description())}};
  }
}

}  // namespace ghostforce
