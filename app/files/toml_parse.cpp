#include "app/files/toml_parse.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include <fmt/format.h>

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

constexpr std::array<std::string_view, 4> toml_words{"true", "false", "inf", "nan"};

// What a person has probably meant in this line, which TOML does not allow; empty: nothing that is known.
std::string slip_in(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) return "";
  std::string_view value = line.substr(equals + 1);
  value.remove_prefix(std::min(value.find_first_not_of(" \t"), value.size()));
  const std::string_view word = value.substr(0, value.find_first_of(" \t\r#"));
  const bool is_letter = !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) != 0;
  const bool is_tomls = std::ranges::find(toml_words, word) != toml_words.end();  // what is wrong comes after it
  if (is_letter && !is_tomls && word.find_first_of("\"'=") == std::string_view::npos) {
    const std::string shown = quoted_text(word);
    return fmt::format("{} stands without quotes; write \"{}\"", shown, shown);
  }
  const std::size_t digits = value.find_first_not_of("+-0123456789");
  return digits != 0 && digits < value.size() && value[digits] == ','
             ? "a number has a comma in it; write a decimal point"
             : "";
}

std::string_view line_of(std::string_view text, toml::source_index number) {
  for (; number > 1; --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
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
    const toml::source_position place = error.source().begin;
    const std::string slip = slip_in(line_of(text, place.line));
    return {{}, TomlProblem{place, slip.empty() ? plain(error.description()) : slip}};
  }
}

}  // namespace ghostforce
