# bash complete.bash SCRIPT LINE...: for each line, "> LINE" and what the completion script offers at its end.
# Divides lines as bash does: '=' and ':' are words of their own.
set -u
source "$1"
shift
compopt() { :; }  # there is no line editor
function=$(complete -p ghostforce | sed 's/.* -F \([^ ]*\) .*/\1/')
for line in "$@"; do
  printf '> %s\n' "$line"
  mapfile -t COMP_WORDS < <(grep -oE '[^ =:]+|[=:]+| $' <<<"$line" | sed 's/^ $//')
  COMP_LINE=$line COMP_POINT=${#line} COMP_CWORD=$((${#COMP_WORDS[@]} - 1)) COMP_WORDBREAKS=$' \t\n"\'><=;|&(:'
  "$function" ghostforce "${COMP_WORDS[COMP_CWORD]}" ''
  printf '%s\n' ${COMPREPLY[@]+"${COMPREPLY[@]}"}
done
