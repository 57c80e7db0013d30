#compdef ghostforce
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
