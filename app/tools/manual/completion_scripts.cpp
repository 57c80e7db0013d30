#include "app/tools/manual/completion.h"

namespace ghostforce {

// It runs in the person's own shell, with whatever options that has.
constexpr std::string_view bash_completion = R"bash(# Completion for ghostforce.
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
  local current=${typed[${#typed[@]} - 1]} paths='' before=''
  COMPREPLY=()
  {
    IFS=' ' read -r paths before
    while IFS=$'\t' read -r word _; do COMPREPLY+=("$word"); done
  } < <("${typed[0]/#'~'/$HOME}" __complete "${typed[@]:1}" 2> /dev/null)

  # A path in quotes is bash's own affair, and so is where it looks: it completes paths if nothing else is offered.
  local value=${current#"$before"}
  if [[ $paths == none ]]; then
    compopt +o default +o bashdefault
  elif [[ $paths && $value != *[\'\"\$]* && $value != '~'* ]]; then
    local plain=${value//\\/}
    compopt -o filenames
    if [[ $paths == folders ]]; then compopt +o default +o bashdefault; fi
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

constexpr std::string_view zsh_completion = R"zsh(#compdef ghostforce
_ghostforce() {
  local program=${${(Q)words[1]}/#\~/$HOME} paths before ret=1
  local -a lines found
  lines=(${(f)"$($program __complete "${(@Q)words[2,CURRENT-1]}" "${(Q)PREFIX}" 2> /dev/null)"})
  paths=${lines[1]%% *} before=${lines[1]#* }
  compset -P ${(b)before}
  lines=(${${lines[2,-1]#$before}//:/\\:})
  lines=(${lines/$'\t'/:})
  found=(${lines:#*(=|\\:)})
  (( $#found )) && _describe -V value found && ret=0
  found=(${(M)lines:#*(=|\\:)})
  (( $#found )) && _describe -V value found -S '' && ret=0
  case $paths in
    any) _files && ret=0 ;;
    toml) _files -g '*.toml' && ret=0 ;;
    folders) _files -/ && ret=0 ;;
  esac
  return ret
}

# As a file of $fpath it is the function; sourced, it says what it completes.
if [[ $funcstack[1] == _ghostforce ]]; then
  _ghostforce "$@"
else
  compdef _ghostforce ghostforce
fi
)zsh";

constexpr std::string_view fish_completion = R"fish(# Completion for ghostforce.
function __ghostforce_complete
    set -l typed (commandline -opc)
    set -l current (commandline -ct)
    set -l program (string replace -r '^~' ~ -- $typed[1])
    set -l answer ($program __complete $typed[2..] "$current" 2>/dev/null)
    string join -- \n $answer[2..]
    set -l kind (string split -m 1 ' ' -- $answer[1])
    set -l before $kind[2]
    set -l value (string sub -s (math 1 + (string length -- "$before")) -- "$current")
    switch "$kind[1]"
        case any
            printf '%s\n' $before(__fish_complete_path $value)
        case toml
            printf '%s\n' $before(__fish_complete_path $value | string match -r -- '^.*(?:/|[.]toml)(?:\t.*)?$')
        case folders
            printf '%s\n' $before(__fish_complete_path $value | string match -r -- '^.*/(?:\t.*)?$')
    end
end

complete -c ghostforce -f -a '(__ghostforce_complete)'
)fish";

}  // namespace ghostforce
