# zsh -f complete.zsh SCRIPT LINE...: for each line, "> LINE" and what the completion script offers at its end. A shell
# on a pseudo-terminal completes them in its line editor; what its completion adds, it also writes into a file.
zmodload zsh/zpty
export SCRIPT=$1 FOUND=$(mktemp)
export LINES_TO_COMPLETE=${(pj:\n:)@[2,-1]}
zpty shell zsh -f -i
zpty -w shell '
  autoload -Uz compinit && compinit -D -u
  source $SCRIPT
  compadd() {
    local -a found
    if [[ " ${(@)*[1,(i)(-|--)]} " != *" -"[OAD]* ]]; then
      builtin compadd -A found "$@"
      (( $#found )) && print -rl -- $found >> $FOUND
    fi
    builtin compadd "$@"
  }
  complete-lines() {
    local line
    for line in ${(f)LINES_TO_COMPLETE}; do
      print -r -- "> $line" >> $FOUND
      BUFFER=$line CURSOR=$#line
      zle list-choices
    done
    exit
  }
  zle -N complete-lines
  bindkey "^I" complete-lines'
zpty -w shell $'\t'
while zpty -r shell answer; do :; done
cat $FOUND
rm $FOUND
