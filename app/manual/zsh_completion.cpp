#include <fmt/format.h>

#include "app/console/shell_word.h"
#include "app/manual/completion.h"
#include "app/manual/completion_text.h"

namespace ghostforce {
namespace {

constexpr std::string_view zsh_helper = R"zsh(
# What may stand as a value: the kind of paths, then words.
_ghostforce_value() {
  local paths=$1 word ret=1
  shift
  for word in ${(M)@:#*:}; do
    if compset -P $word; then
      _files
      return
    fi
  done
  compadd -- ${@:#*[=:]} && ret=0
  compadd -S '' -- ${(M)@:#*[=:]} && ret=0
  case $paths in
    any) _files && ret=0 ;;
    toml) _files -g '*.toml' && ret=0 ;;
    folders) _files -/ && ret=0 ;;
  esac
  return ret
}
)zsh";

// Its first word is a command, or belongs to the default one.
constexpr std::string_view zsh_function = R"zsh(
_ghostforce() {
  local command=@default@ ret=1
  local -a commands=(
@commands@  )
  if (( CURRENT == 2 )); then
    if [[ $PREFIX == -* ]]; then
      compadd -- @options@ && ret=0
    else
      _describe command commands && ret=0
    fi
  elif (( $+functions[_ghostforce-$words[2]] )); then
    command=$words[2]
    shift words
    (( CURRENT-- ))
  fi
  _ghostforce-$command && ret=0
  return ret
}

# As a file of $fpath it is the function; sourced, it says what it completes.
if [[ $funcstack[1] == _ghostforce ]]; then
  _ghostforce "$@"
else
  compdef _ghostforce ghostforce
fi
)zsh";

std::string quoted_in_zsh(std::string_view text) {
  return fmt::format("'{}'", with_replaced(text, "'", R"('\'')"));
}

std::string escaped(std::string_view text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

// ":MESSAGE:ACTION" of _arguments; the message is what stands for the value.
std::string value_part(const ManualOption& option) {
  std::string action;
  if (option.is_list) {
    action = " _sequence compadd -";
  } else if (!option.words.empty() || option.paths != ManualPaths::none) {
    action = fmt::format(" _ghostforce_value {}", name_of(option.paths));
  }
  if (!action.empty()) {
    for (const std::string& word : option.words) action += fmt::format(" {}", escaped(shell_word(word), ":"));
  }
  return fmt::format(":{}:{}", escaped(option.value, ":\\"), action);
}

// What _arguments knows of an option, for each of its names: which options are not offered beside it, and the rest.
std::string zsh_rows(const ManualOption& option) {
  const bool repeats = option.may_repeat || option.takes_many;
  std::vector<std::string> excluded = option.excluded;
  if (!repeats) excluded.insert(excluded.end(), option.names.begin(), option.names.end());
  const std::string before = fmt::format("({}){}", fmt::join(excluded, " "), repeats ? "*" : "");
  std::string rows;
  for (const std::string& name : option.names) {
    const bool is_long = name.starts_with("--");
    // Both "--name VALUE" and "--name=VALUE", both "-n VALUE" and "-nVALUE"; of several values each is a word.
    const char* const joint = !option.has_value() || option.takes_many ? "" : is_long ? "=" : "+";
    const std::string value =
        !option.has_value() ? "" : fmt::format("{}{}", option.takes_many ? ":*-*" : "", value_part(option));
    rows +=
        fmt::format("    {} \\\n", quoted_in_zsh(fmt::format("{}{}{}[{}]{}", before, name, joint,
                                                             escaped(first_clause(option.sentence), "[]\\"), value)));
  }
  return rows;
}

std::string function_of(const ManualCommand& command) {
  std::string text = fmt::format("\n_ghostforce-{}() {{\n  _arguments -S \\\n", command.name);
  for (const ManualOption& option : command.options) text += zsh_rows(option);
  for (const ManualOption& argument : command.arguments) {
    text += fmt::format("    {} \\\n",
                        quoted_in_zsh(fmt::format("{}{}", argument.takes_many ? "*" : "", value_part(argument))));
  }
  text.erase(text.size() - 3);
  return text + "\n}\n";
}

}  // namespace

std::string zsh_completion(const Manual& manual) {
  std::string functions;
  std::string commands;
  for (const ManualCommand& command : manual.commands) {
    functions += function_of(command);
    commands += fmt::format("    {}\n", quoted_in_zsh(fmt::format("{}:{}", command.name, command.sentence)));
  }
  std::vector<std::string> options;
  for (const ManualOption& option : manual.program.options) {
    options.insert(options.end(), option.names.begin(), option.names.end());
  }
  std::string text =
      fmt::format("#compdef ghostforce\n{}{}{}{}", made_by(manual, "zsh"), zsh_helper, functions, zsh_function);
  text = with_replaced(text, "@default@", manual.default_command);
  text = with_replaced(text, "@commands@", commands);
  return with_replaced(text, "@options@", fmt::format("{}", fmt::join(options, " ")));
}

}  // namespace ghostforce
