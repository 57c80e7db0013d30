# Completion for ghostforce.
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
