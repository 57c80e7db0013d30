#include "app/files/toml_parse.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"

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

// What TOML has without quotes, and how else people write it.
struct BareWord {
  std::string_view written;  // in small letters
  std::string_view toml;
};
constexpr std::array bare_words{BareWord{"true", "true"}, BareWord{"false", "false"}, BareWord{"inf", "inf"},
                                BareWord{"infinity", "inf"}, BareWord{"nan", "nan"}};

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::string likely_mistake_in_word(std::string_view value) {
  std::string small(value.substr(0, value.find_first_of(" \t")));
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
  const auto* const bare = std::ranges::find(bare_words, small, &BareWord::written);
  if (bare == bare_words.end()) {
    const std::string shown = quoted_text(value);
    return fmt::format("{} stands without quotes; write \"{}\"", shown, shown);
  }
  if (small.size() < value.size() || value == bare->toml) return "";  // something else is wrong
  return fmt::format("TOML has no {}; write {}", quoted_text(value), bare->toml);
}

std::string likely_mistake_in_number(std::string_view value) {
  const std::size_t comma = value.find(',');
  const std::string_view before = value.substr(0, comma);
  const bool is_number = comma != std::string_view::npos && std::ranges::any_of(before, is_digit) &&
                         before.find_first_not_of("+-.0123456789") == std::string_view::npos;
  if (!is_number) return "";
  if (comma + 1 == value.size()) return "a comma stands at the end; leave it out";
  return is_digit(value[comma + 1]) ? "a number has a comma in it; write a decimal point" : "";
}

// What a person has probably meant in this line, where TOML refuses something at this column, from 1; empty: nothing
// that is known.
std::string likely_mistake(std::string_view line, std::size_t column) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos || column <= equals + 1) return "";
  const std::string_view value = trimmed(line.substr(equals + 1, line.find('#', equals) - equals - 1));
  if (value.empty()) return "";
  const bool is_word = std::isalpha(static_cast<unsigned char>(value.front())) != 0;
  if (!is_word) return likely_mistake_in_number(value);
  return value.find_first_of("\"'=[]{},") == std::string_view::npos ? likely_mistake_in_word(value) : "";
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
    const std::string mistake = likely_mistake(line_of(text, place.line), place.column);
    return {{}, TomlProblem{place, mistake.empty() ? plain(error.description()) : mistake}};
  }
}

}  // namespace ghostforce
