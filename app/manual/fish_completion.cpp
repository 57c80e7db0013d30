#include <fmt/format.h>

#include "app/manual/completion.h"
#include "app/manual/completion_text.h"

namespace ghostforce {
namespace {

constexpr std::string_view fish_functions = R"fish(
# Whether the command that is typed is one of these. A first word that names no command belongs to the default one.
function __ghostforce_is
    set -l typed (commandline -opc)
    set -l command @default@
    if set -q typed[2]; and contains -- $typed[2] @commands@
        set command $typed[2]
    end
    contains -- $command $argv
end

# Whether the first word is being typed.
function __ghostforce_begins
    set -l typed (commandline -opc)
    test (count $typed) -eq 1
end

# Whether the last option that was typed is one of these, which take several values.
function __ghostforce_after
    set -l options (commandline -opc | string match -r -- '^-.+')
    contains -- "$options[-1]" $argv
end

# What is typed of the value, with or without its option.
function __ghostforce_value
    string replace -r -- '^--[^=]*=' '' (commandline -ct)
end

# Words in a list with commas: those that go on after what is there.
function __ghostforce_list
    set -l before (string match -r -- '^.*,' (__ghostforce_value))
    printf '%s\n' $before$argv
end

function __ghostforce_paths
    __fish_complete_path (__ghostforce_value)
end

function __ghostforce_toml_files
    __ghostforce_paths | string match -r -- '^.*(?:/|[.]toml)(?:\t.*)?$'
end

function __ghostforce_folders
    __ghostforce_paths | string match -r -- '^.*/(?:\t.*)?$'
end

# The paths after a word.
function __ghostforce_paths_after
    set -l value (__ghostforce_value)
    if string match -q -- "$argv*" $value
        printf '%s\n' $argv(__fish_complete_path (string replace -- $argv '' $value))
    end
end

complete -c ghostforce -f
)fish";

std::string quoted_in_fish(std::string_view text) {
  return fmt::format("'{}'", with_replaced(with_replaced(text, "\\", "\\\\"), "'", "\\'"));
}

// What fish runs to know the values.
std::string values_of(const ManualOption& option) {
  const std::string words = fmt::format("{}", fmt::join(option.words, " "));
  if (option.is_list) return fmt::format("(__ghostforce_list {})", words);
  std::string values = words;
  for (const std::string& word : option.words) {
    if (word.ends_with(':')) values += fmt::format(" (__ghostforce_paths_after {})", word);
  }
  if (option.paths == ManualPaths::any) values += " (__ghostforce_paths)";
  if (option.paths == ManualPaths::toml) values += " (__ghostforce_toml_files)";
  if (option.paths == ManualPaths::folders) values += " (__ghostforce_folders)";
  return values;
}

std::string fish_row(std::string_view rest, std::string_view condition) {
  return fmt::format("complete -c ghostforce -n {}{}\n", quoted_in_fish(condition), rest);
}

std::string names_in_fish(const ManualOption& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += name.starts_with("--") ? fmt::format(" -l {}", name.substr(2)) : fmt::format(" -s {}", name.substr(1));
  }
  return names;
}

std::string sentence_in_fish(std::string_view sentence) {
  return fmt::format(" -d {}", quoted_in_fish(first_clause(sentence)));
}

std::string fish_option(const ManualOption& option, const std::string& condition) {
  std::string rest = names_in_fish(option);
  if (option.has_value()) rest += " -x";
  const std::string values = values_of(option);
  const std::string offers = values.empty() ? "" : fmt::format(" -a {}", quoted_in_fish(values));
  std::string rows = fish_row(rest + offers + sentence_in_fish(option.sentence), condition);
  if (option.takes_many && !values.empty()) {
    rows += fish_row(offers, fmt::format("{}; and __ghostforce_after {}", condition, fmt::join(option.names, " ")));
  }
  return rows;
}

}  // namespace

std::string fish_completion(const Manual& manual) {
  std::string rows;
  std::vector<std::string> commands;
  for (const ManualOption& option : manual.program.options) rows += fish_option(option, "__ghostforce_begins");
  for (const ManualCommand& command : manual.commands) {
    commands.push_back(command.name);
    rows += fish_row(fmt::format(" -a {}{}", command.name, sentence_in_fish(command.sentence)), "__ghostforce_begins");
    const std::string condition = fmt::format("__ghostforce_is {}", command.name);
    for (const ManualOption& option : command.options) rows += fish_option(option, condition);
    for (const ManualOption& argument : command.arguments) {
      rows += fish_row(fmt::format(" -a {}", quoted_in_fish(values_of(argument))), condition);
    }
  }
  std::string functions(fish_functions);
  functions = with_replaced(functions, "@default@", manual.default_command);
  functions = with_replaced(functions, "@commands@", fmt::format("{}", fmt::join(commands, " ")));
  return made_by(manual, "fish") + functions + rows;
}

}  // namespace ghostforce
