#include <fmt/format.h>

#include "app/console/shell_word.h"
#include "app/manual/completion.h"
#include "app/manual/completion_text.h"

namespace ghostforce {
namespace {

// Reads the table below. It runs in the person's own shell, with whatever options that has.
constexpr std::string_view bash_function = R"bash(
_ghostforce() {
  # Bash also divides words at '=' and ':': put together what has no blank between it.
  local IFS=$' \t\n' line=${COMP_LINE:0:COMP_POINT} typed=() word i
  for ((i = 0; i <= COMP_CWORD; ++i)); do
    word=${COMP_WORDS[i]}
    if ((i == 0)) || [[ $line == [[:space:]]* ]]; then
      line=${line#"${line%%[![:space:]]*}"}
      typed+=('')
    fi
    if ((i == COMP_CWORD)); then word=$line; fi
    typed[${#typed[@]} - 1]+=$word
    line=${line#"$word"}
  done
  local current=${typed[${#typed[@]} - 1]}
  typed=("${typed[@]:1:${#typed[@]}-2}")

  # A first word that names no command belongs to the default one.
  local command=@default@ names='' words=() values=none paths=none list=''
  COMPREPLY=()
  if ((${#typed[@]} == 0)); then
    names='@commands@ @options@'
  elif [[ ' @commands@ ' == *" ${typed[0]} "* ]]; then
    command=${typed[0]}
    typed=("${typed[@]:1}")
  fi

  # Which option is waiting for a value, and how many arguments there are.
  local open='' arguments=0
  for word in ${typed[@]+"${typed[@]}"}; do
    if [[ $open && $values == one ]]; then
      open=''
    elif [[ $word == -?* ]]; then
      open=''
      if [[ $word != *=* ]]; then
        _ghostforce_values "$command" "$word"
        if [[ $values != none ]]; then open=$word; fi
      fi
    elif [[ -z $open ]]; then
      ((++arguments))
    fi
  done

  local before='' value=$current
  if [[ $open && ($values == one || $current != -*) ]]; then
    _ghostforce_values "$command" "$open"
  elif [[ $current == --*=* ]]; then
    before=${current%%=*}= value=${current#*=}
    _ghostforce_values "$command" "${current%%=*}"
  elif [[ $current == -* ]]; then
    _ghostforce_values "$command" options
  else
    _ghostforce_values "$command" "$arguments"
  fi
  if [[ $list && $value == *,* ]]; then before+=${value%"${value##*,}"} value=${value##*,}; fi

  for word in $names ${words[@]+"${words[@]}"}; do
    if [[ $word == *: && $value == "$word"* ]]; then
      paths=any before+=$word value=${value#"$word"} COMPREPLY=()
      break
    fi
    if [[ $word == "$value"* ]]; then COMPREPLY+=("$before$word"); fi
  done

  # A path in quotes is bash's own affair, and so is where it looks: it completes paths if nothing else is offered.
  if [[ $paths == none ]]; then
    compopt +o default +o bashdefault
  elif [[ $value != *[\'\"\$]* && $value != '~'* ]]; then
    local plain=${value//\\/}
    compopt -o filenames
    while IFS='' read -r word; do
      COMPREPLY+=("$before$word")
    done < <(
      case $paths in
        any) compgen -f -- "$plain" ;;
        toml) compgen -f -X '!*.toml' -- "$plain"; compgen -d -- "$plain" ;;
        folders) compgen -d -- "$plain" ;;
      esac
    )
  fi

  # Of a divided word, bash replaces only the last part.
  local dividers=${COMP_WORDBREAKS//[!=:]/}
  if [[ $dividers && $current == *[$dividers]* ]]; then
    local kept=${current%"${current##*[$dividers]}"}
    COMPREPLY=(${COMPREPLY[@]+"${COMPREPLY[@]#"$kept"}"})
  fi
  if [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *[=:] ]]; then compopt -o nospace; fi
}

complete -o bashdefault -o default -F _ghostforce ghostforce
)bash";

std::string words_in_bash(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += fmt::format("{}{}", list.empty() ? "" : " ", shell_word(word));
  return list;
}

// A row of the table: what it is for, each as the command and the option or the number of the argument.
std::string bash_case(const std::vector<std::string>& patterns, const ManualOption& option) {
  std::string set;
  if (!option.words.empty()) set += fmt::format(" words=({})", words_in_bash(option.words));
  if (option.has_value()) set += option.takes_many ? " values=many" : " values=one";
  if (option.paths != ManualPaths::none) set += fmt::format(" paths={}", name_of(option.paths));
  if (option.is_list) set += " list=yes";
  return set.empty() ? "" : fmt::format("    {}){} ;;\n", fmt::join(patterns, " | "), set);
}

std::string bash_cases(const ManualCommand& command) {
  std::string text;
  std::vector<std::string> names;
  for (const ManualOption& option : command.options) {
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) {
      names.push_back(name);
      patterns.push_back(fmt::format("'{} {}'", command.name, name));
    }
    text += bash_case(patterns, option);
  }
  for (std::size_t i = 0; i < command.arguments.size(); ++i) {
    const ManualOption& argument = command.arguments[i];
    text +=
        bash_case({fmt::format("'{} '{}", command.name, argument.takes_many ? "[0-9]*" : std::to_string(i))}, argument);
  }
  return text + fmt::format("    '{} options') words=({}) ;;\n", command.name, words_in_bash(names));
}

}  // namespace

std::string bash_completion(const Manual& manual) {
  std::string table;
  std::vector<std::string> commands;
  for (const ManualCommand& command : manual.commands) {
    commands.push_back(command.name);
    table += bash_cases(command);
  }
  std::vector<std::string> options;
  for (const ManualOption& option : manual.program.options) {
    options.insert(options.end(), option.names.begin(), option.names.end());
  }
  std::string function(bash_function);
  function = with_replaced(function, "@default@", manual.default_command);
  function = with_replaced(function, "@commands@", fmt::format("{}", fmt::join(commands, " ")));
  function = with_replaced(function, "@options@", fmt::format("{}", fmt::join(options, " ")));
  return fmt::format(
      "{}\n# What may stand after an option of a command, or as an argument.\n_ghostforce_values() {{\n"
      "  words=() values=none paths=none list=''\n  case \"$1 $2\" in\n{}  esac\n}}\n{}",
      made_by(manual, "bash"), table, function);
}

}  // namespace ghostforce
