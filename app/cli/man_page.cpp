#include "app/cli/manual.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "app/base/quoted.h"
#include "app/base/typed_text.h"

namespace ghostforce {
namespace {

// What groff would take for a command, or show as a typographic sign that no shell understands.
constexpr std::array roff_names{
    std::pair{'\\', R"(\(rs)"}, std::pair{'-', R"(\-)"},   std::pair{'\'', R"(\(aq)"}, std::pair{'"', R"(\(dq)"},
    std::pair{'`', R"(\(ga)"},  std::pair{'^', R"(\(ha)"}, std::pair{'~', R"(\(ti)"},
};

std::string bold(std::string_view text) {
  return fmt::format(R"(\fB{}\fR)", roff_text(text));
}

std::string italic(std::string_view text) {
  return fmt::format(R"(\fI{}\fR)", roff_text(text));
}

std::vector<std::string_view> split_at(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) parts.push_back(take_until(text, separator));
  return parts;
}

bool ends_sentence(std::string_view word) {
  const std::size_t last = word.find_last_not_of("')\"");
  return last != std::string_view::npos && (word[last] == '.' || word[last] == '?' || word[last] == '!');
}

// Text that is filled. Each sentence ends its line: groff puts a wider space only there.
std::string filled(std::string_view text) {
  constexpr std::size_t longest_line = 76;
  std::string lines;
  std::string line;
  const auto end_line = [&] {
    if (line.empty()) return;
    if (line.front() == '.') lines += R"(\&)";
    lines += std::exchange(line, {}) + '\n';
  };
  for (const std::string_view word : split_at(text, ' ')) {
    if (word.empty()) continue;
    const std::string escaped = roff_text(word);
    if (!line.empty() && line.size() + 1 + escaped.size() > longest_line) end_line();
    line += fmt::format("{}{}", line.empty() ? "" : " ", escaped);
    if (ends_sentence(word)) end_line();
  }
  end_line();
  return lines;
}

bool is_verbatim(std::string_view line) noexcept {
  return line.starts_with("  ");
}

std::string verbatim(std::span<const std::string_view> lines) {
  std::string text = ".RS 4\n.EX\n";
  for (const std::string_view line : lines) {
    const std::string escaped = roff_text(is_verbatim(line) ? line.substr(2) : line);
    text += fmt::format("{}{}\n", escaped.starts_with('.') ? R"(\&)" : "", escaped);
  }
  return text + ".EE\n.RE\n";
}

// Paragraphs, and between them what stays as it is.
std::string paragraphs(std::string_view text) {
  const std::vector<std::string_view> lines = split_at(text, '\n');
  std::string page;
  for (auto line = lines.begin(); line != lines.end();) {
    if (line->empty()) {
      ++line;
      continue;
    }
    const bool stays = is_verbatim(*line);
    const auto end = std::find_if(line, lines.end(),
                                  [&](std::string_view each) { return each.empty() || is_verbatim(each) != stays; });
    if (!page.empty()) page += ".PP\n";
    page += stays ? verbatim({line, end}) : filled(fmt::format("{}", fmt::join(line, end, " ")));
    line = end;
  }
  return page;
}

std::string section(std::string_view title, const std::string& text) {
  return text.empty() ? text : fmt::format(".SH {}\n{}", title, text);
}

std::string entry(const std::string& tag, std::string_view text) {
  return fmt::format(".TP\n{}\n{}", tag, filled(text));
}

std::string entries(std::span<const ManualRow> rows) {
  std::string text;
  for (const ManualRow& row : rows) text += entry(bold(row.name), row.meaning);
  return text;
}

// What stands for the value, with "..." where there may be more of them.
std::string value_of(const ManualOption& option) {
  return italic(option.value) + (option.takes_many ? " ..." : "");
}

// All that is to be said of an option, in whole sentences.
std::string sentences_on(const ManualOption& option) {
  std::string text = option.sentence;
  if (!ends_sentence(text)) text += '.';
  if (option.is_required) text += " Required.";
  if (!option.needed.empty()) text += fmt::format(" Only with {}.", fmt::join(option.needed, ", "));
  if (!option.excluded.empty()) text += fmt::format(" Not with {}.", fmt::join(option.excluded, ", "));
  return text;
}

std::string option_entries(std::span<const ManualOption> options) {
  std::string text;
  for (const ManualOption& option : options) {
    std::vector<std::string> names;
    std::ranges::transform(option.names, std::back_inserter(names), bold);
    text += entry(
        fmt::format("{}{}", fmt::join(names, ", "), option.has_value() ? fmt::format(" {}", value_of(option)) : ""),
        sentences_on(option));
  }
  return text;
}

std::string argument_entries(std::span<const ManualOption> arguments) {
  std::string text;
  for (const ManualOption& argument : arguments) text += entry(value_of(argument), sentences_on(argument));
  return text;
}

// What follows the command's name: what must be there as it is, the rest in brackets.
std::string synopsis(const ManualCommand& command) {
  std::string text = R"([\fIOPTION\fR ...])";
  for (const ManualOption& option : command.options) {
    if (option.is_required) text += fmt::format(" {} {}", bold(option.names.front()), value_of(option));
  }
  for (const ManualOption& argument : command.arguments) {
    const std::string value = value_of(argument);
    text += argument.is_required ? fmt::format(" {}", value) : fmt::format(" [{}]", value);
  }
  return text;
}

std::string page_name(const Manual& manual, const ManualCommand& command) {
  return fmt::format("{}-{}", manual.program.name, command.name);
}

std::string reference(std::string_view page) {
  return fmt::format(".BR {} (1)", roff_text(page));
}

// No word is cut in two, since most could be copied. The title has no date: a page says of which version it is,
// and the same program always writes the same page.
std::string beginning(const Manual& manual, std::string_view page, std::string_view sentence) {
  std::string title(page);
  for (char& c : title) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  std::string words(sentence);  // they go on after the name
  if (!words.empty() && words[0] >= 'A' && words[0] <= 'Z') words[0] = static_cast<char>(words[0] - 'A' + 'a');
  return fmt::format(".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n.nh\n.ad l\n.SH NAME\n{} \\- {}\n", title,
                     manual.program.name, roff_text(manual.version), roff_text(page), roff_text(words));
}

}  // namespace

std::string roff_text(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const Character character = first_character(text);
    const std::size_t length = std::max<std::size_t>(character.length, 1);
    const auto* const named = std::ranges::find(roff_names, text.front(), &std::pair<char, const char*>::first);
    if (named != roff_names.end()) {
      escaped += named->second;
    } else if (character.code > 0x7f) {
      escaped += fmt::format("\\[u{:04X}]", static_cast<unsigned>(character.code));
    } else {
      escaped += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return escaped;
}

std::string man_page(const Manual& manual) {
  const ManualCommand& program = manual.program;
  const std::string name = bold(program.name);
  std::string commands;
  std::string see_also;
  for (const ManualCommand& command : manual.commands) {
    const std::string page = page_name(manual, command);
    commands += fmt::format(".TP\n{}\n{}", reference(page), filled(command.sentence));
    see_also += fmt::format("{}{}", see_also.empty() ? "" : ",\n", reference(page));
  }
  return beginning(manual, program.name, program.sentence) +
         section("SYNOPSIS",
                 fmt::format("{} [{}] {}\n.br\n{} \\fICOMMAND\\fR [\\fIOPTION\\fR ...] [\\fIARGUMENT\\fR "
                             "...]\n.br\n{} \\fBhelp\\fR [\\fICOMMAND\\fR]\n",
                             name, bold(manual.default_command), "[\\fIOPTION\\fR ...] [\\fISCENE\\fR]", name, name)) +
         section("DESCRIPTION", paragraphs(program.notes)) + section("COMMANDS", commands) +
         section("OPTIONS", option_entries(program.options)) + section("EXIT STATUS", entries(manual.exit_codes)) +
         section("ENVIRONMENT", entries(manual.environment)) + section("FILES", entries(manual.files)) +
         section("EXAMPLES", verbatim(split_at(program.examples, '\n'))) + section("SEE ALSO", see_also + "\n");
}

std::string man_page(const Manual& manual, const ManualCommand& command) {
  const std::string notes = paragraphs(command.notes);
  const std::string arguments = argument_entries(command.arguments);
  return beginning(manual, page_name(manual, command), command.sentence) +
         section("SYNOPSIS",
                 fmt::format("{} {}\n", bold(manual.program.name + " " + command.name), synopsis(command))) +
         section("DESCRIPTION", filled(command.sentence + ".") + (notes.empty() ? "" : ".PP\n" + notes)) +
         section("ARGUMENTS", arguments) + section("OPTIONS", option_entries(command.options)) +
         section("EXIT STATUS", entries(manual.exit_codes)) +
         section("EXAMPLES", command.examples.empty() ? "" : verbatim(split_at(command.examples, '\n'))) +
         section("SEE ALSO", reference(manual.program.name) + "\n");
}

}  // namespace ghostforce
